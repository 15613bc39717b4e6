#include "walk_tests/random_walks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "random_levels/random_level.h"

namespace hearth::random_walks {
namespace {

TEST(RandomWalks, KeepEveryPromise) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-walks-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  Report report;
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
    report += walkRandomLevel(seed, folder, {5, 400, 3});
  std::filesystem::remove_all(folder);
  EXPECT_EQ(report.failures, 0u) << report.first;
  EXPECT_GT(report.crossings, 300u) << "the walker must get around";
  EXPECT_GT(report.throughFlats, 10u);
}

TEST(RandomWalks, KeepEveryPromiseWhereThingsMove) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-moving-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  Report report;
  for (std::uint64_t seed = 1; seed <= 15; ++seed)
    report += walkMovingLevel(seed, folder, {5, 400, 3});
  std::filesystem::remove_all(folder);
  EXPECT_EQ(report.failures, 0u) << report.first;
  EXPECT_GT(report.whileMoving, 5000u) << inWords(report);
  EXPECT_GT(report.turnedBack, 10u) << inWords(report);
  EXPECT_GT(report.replays, 50u) << inWords(report);
}

TEST(RandomWalks, NeverEndInsideASolidThing) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-bodies-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  Report report;
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    report += walkRandomLevel(seed, folder, {5, 400, 3}, 12);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(report.failures, 0u) << report.first;
  EXPECT_GT(report.onThings, 300u);
  EXPECT_GT(report.againstThings, 300u);
}

TEST(RandomWalks, TakeEveryStraightWayThatASearchCallsOpen) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-ways-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  WaysReport report;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) report += tryWays(seed, folder, 10);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(report.taken, report.asked) << report.first;
  EXPECT_GT(report.asked, 100);
}

}  // namespace
}  // namespace hearth::random_walks
