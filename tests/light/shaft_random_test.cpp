// Whether bakes with shafts are those of rays, in a hundred random levels.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "both_bakes.h"

namespace hearth {
namespace {

TEST(Shafts, giveTheBytesOfRaysInManyRandomLevels) { test::expectSameRandomBakes(1000, 1100); }

/// A slope there comes through a flat portal by micrometres, or a surface ends in a vertex.
TEST(Shafts, giveTheBytesOfRaysWhereLittleIsLeftOfAPortalOrASurface) {
  const test::RandomLevels levels;
  for (const std::uint64_t seed : {6012, 6866, 13760, 17918}) {
    const LoadedLevel loaded = levels.level(seed);
    BakeSettings settings = loaded.level.bake;
    settings.texel = 0.5;
    settings.samples = 1;
    settings.softSamples = 0;
    test::BothCosts costs;
    test::expectSameBakes(loaded.scene(), settings, fmt::format("seed {}", seed), costs);
  }
}

}  // namespace
}  // namespace hearth
