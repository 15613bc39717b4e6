#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "agreement/compare_level.h"
#include "random_levels/random_level.h"

namespace hearth::agreement {
namespace {

TEST(Agreement, isCompleteOnManyRandomLevels) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-agreement-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  Tally tally;
  for (std::uint64_t seed = 10001; seed <= 10300; ++seed) tally += compareRandomLevel(seed, folder);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(tally.holes, 0) << tally.firstMiss;
  EXPECT_EQ(tally.missed(), 0) << tally.firstMiss << '\n' << table(tally);
  EXPECT_GE(tally.minTested(), 1000) << table(tally);
  EXPECT_EQ(beyond(kRandomLevels, fractionsOf(tally)), "") << table(tally);
}

}  // namespace
}  // namespace hearth::agreement
