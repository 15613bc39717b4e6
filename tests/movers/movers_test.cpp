#include <gtest/gtest.h>

#include "movers/compare_movers.h"
#include "random_levels/random_level.h"
#include "support/temporary_folder.h"

namespace hearth::movers {
namespace {

/// Few: under the sanitizers 30 would take five minutes.
TEST(MoversOfRandomLevels, standAtTheirEndsAsIfAuthoredThereAndBetweenThemAsTruthHasIt) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeRandomLevelTextures(folder.path() / "textures"));
  MoverTally tally;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    tally += compareRandomMovers(seed, folder.path());
  EXPECT_EQ(tally.failed, 0) << tally.firstFailure;
  EXPECT_GE(tally.levels, 9) << inWords(tally);
  EXPECT_GE(tally.movers, 2 * tally.levels) << inWords(tally);
  EXPECT_GE(tally.between, 9) << inWords(tally);
  EXPECT_GE(tally.lightTexels, 10000) << inWords(tally);
}

}  // namespace
}  // namespace hearth::movers
