#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "agreement/compare_level.h"
#include "random_levels/random_level.h"
#include "support/in_tree.h"

namespace hearth::agreement {
namespace {

TEST(Agreement, isCompleteOnRandomLevels) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-agreement-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) tally += compareRandomLevel(seed, folder);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(tally.holes, 0) << tally.firstMiss;
  EXPECT_EQ(tally.missed(), 0) << tally.firstMiss << '\n' << table(tally);
  EXPECT_GE(tally.minTested(), 500) << table(tally);
  EXPECT_EQ(beyond(kRandomLevels, fractionsOf(tally)), "") << table(tally);
}

TEST(Agreement, isCompleteOnTheTutorial) {
  const LoadResult result = loadLevel(test::inTree("levels/tutorial.json"));
  ASSERT_TRUE(result.loaded);
  const Tally tally = compareLevel(*result.loaded, "tutorial", 100);
  EXPECT_GE(tally.views, 20);
  EXPECT_EQ(tally.holes, 0) << tally.firstMiss;
  EXPECT_EQ(tally.missed(), 0) << tally.firstMiss << '\n' << table(tally);
  EXPECT_EQ(beyond(kTutorial, fractionsOf(tally)), "") << table(tally);
}

TEST(Agreement, takesBallsForPointsAndAutoForOneSample) {
  const LoadResult result = loadLevel(test::inTree("tests/levels/rooms.json"));
  ASSERT_TRUE(result.loaded);
  LoadedLevel level = *result.loaded;
  const std::string expected = table(compareLevel(level, "points", 1));
  for (LightSource& light : level.level.lights) light.radius = 0.5;
  level.level.bake.samples.reset();
  EXPECT_EQ(table(compareLevel(level, "balls", 1)), expected);
}

}  // namespace
}  // namespace hearth::agreement
