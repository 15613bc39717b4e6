#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "agreement/compare_level.h"
#include "random_levels/random_level.h"

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
}

TEST(Agreement, isCompleteOnTheTutorial) {
  const LoadResult result = loadLevel(HEARTH_SOURCE_DIR "/levels/tutorial.json");
  ASSERT_TRUE(result.loaded);
  const Tally tally = compareLevel(*result.loaded, "tutorial", 100);
  EXPECT_GE(tally.views, 20);
  EXPECT_EQ(tally.holes, 0) << tally.firstMiss;
  EXPECT_EQ(tally.missed(), 0) << tally.firstMiss << '\n' << table(tally);
}

}  // namespace
}  // namespace hearth::agreement
