// Whether bakes with shafts are those of rays, in a hundred random levels and in those of the tree.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "both_bakes.h"
#include "support/in_tree.h"

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

TEST(Shafts, giveTheBytesOfRaysInTheLevelsOfTheTree) {
  for (const auto& [name, texel] :
       {std::pair{"levels/tutorial.json", 0.5}, std::pair{"levels/gaol.json", 0.25},
        std::pair{"levels/keep.json", 1.0}}) {
    const LoadResult result = loadLevel(test::inTree(name));
    ASSERT_TRUE(result.loaded);
    BakeSettings settings = result.loaded->level.bake;
    settings.texel = texel;
    test::BothCosts costs;
    test::expectSameBakes(result.loaded->scene(), settings, name, costs);
    EXPECT_LT(4 * costs.byShafts.rays, costs.byRays.rays) << name;
  }
}

}  // namespace
}  // namespace hearth
