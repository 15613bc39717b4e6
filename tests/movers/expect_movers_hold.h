#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "movers/compare_movers.h"
#include "random_levels/random_level.h"
#include "support/temporary_folder.h"

namespace hearth::movers {

/// Expects that the first random levels hold, and that something moves in so many of them at least.
inline void expectMoversHold(std::uint64_t levels, std::int64_t least) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeRandomLevelTextures(folder.path() / "textures"));
  MoverTally tally;
  for (std::uint64_t seed = 1; seed <= levels; ++seed)
    tally += compareRandomMovers(seed, folder.path());
  EXPECT_EQ(tally.failed, 0) << tally.firstFailure;
  EXPECT_GE(tally.levels, least) << inWords(tally);
  EXPECT_GE(tally.movers, 2 * tally.levels) << inWords(tally);
  EXPECT_GE(tally.between, least) << inWords(tally);
  EXPECT_GE(tally.lightTexels, 10000) << inWords(tally);
}

}  // namespace hearth::movers
