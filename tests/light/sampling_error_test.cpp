// Samples per texel: what more of them give, and what they cost.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "light/bakery.h"
#include "load/load.h"
#include "math/parallel.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

BakedLight bakedWith(const Scene& scene, std::optional<int> samples) {
  BakeSettings settings = scene.level().bake;
  settings.samples = samples;
  return bake(scene, settings, availableThreads());
}

/// Over all texels of two bakes of one level, in levels.
double rmsBetween(const BakedLight& a, const BakedLight& b) {
  double sum = 0;
  std::int64_t texels = 0;
  for (std::size_t s = 0; s < a.lightmaps.size(); ++s) {
    if (!a.lightmaps[s] && !b.lightmaps[s]) continue;
    const TexelRect rect = a.surfaces[s]->texels;
    const auto level = [&](const BakedLight& light, int i, int j, int channel) {
      return light.lightmaps[s] ? light.lightmaps[s]->at(i, j, channel) : 0;
    };
    for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
      for (int i = rect.i0; i < rect.i0 + rect.width; ++i)
        for (int channel = 0; channel < 3; ++channel, ++texels)
          sum += std::pow(level(a, i, j, channel) - level(b, i, j, channel), 2);
  }
  return std::sqrt(sum / static_cast<double>(texels));
}

/// Errors and costs of 1, 4, 16 and as many samples as shadows need.
struct Cost {
  double levelsRms;
  std::int64_t tests;  ///< pairs of a sample and a light
};
struct Costs {
  Cost of1;
  Cost of4;
  Cost of16;
  Cost ofAuto;
};

Costs costsAgainst(const BakedLight& exact, const Scene& scene) {
  const auto measure = [&](std::string_view name, std::optional<int> samples) {
    const BakedLight light = bakedWith(scene, samples);
    Cost cost{rmsBetween(light, exact), 0};
    for (const LightCost& ofLight : light.lightCosts) cost.tests += ofLight.samples;
    fmt::print("{:>4} samples: {:.3f} levels rms, {} tests, {} rays\n", name, cost.levelsRms,
               cost.tests, light.stats.rays);
    return cost;
  };
  return {measure("1", 1), measure("4", 4), measure("16", 16), measure("auto", std::nullopt)};
}

LoadedLevel tutorial() {
  const LoadResult result = loadLevel(test::inTree("levels/tutorial.json"));
  EXPECT_TRUE(result.loaded);
  return result.loaded.value_or(LoadedLevel{});
}

TEST(Sampling, asShadowsNeedErrsLessThan16ForOneAndAHalfTimesTheTestsOfOne) {
  LoadedLevel loaded = tutorial();
  for (LightSource& light : loaded.level.lights) light.radius = 0;
  const Costs costs = costsAgainst(bakedWith(loaded.scene(), 196), loaded.scene());
  EXPECT_LT(costs.of4.levelsRms, costs.of1.levelsRms);
  EXPECT_LT(costs.of16.levelsRms, costs.of4.levelsRms);
  EXPECT_EQ(costs.of16.tests, 16 * costs.of1.tests);
  EXPECT_LE(costs.ofAuto.levelsRms, costs.of16.levelsRms);
  EXPECT_LE(2 * costs.ofAuto.tests, 3 * costs.of1.tests);
}

TEST(Sampling, asShadowsOfBallsNeedErrsLessThan16ForOneAndAHalfTimesTheTestsOfOne) {
  LoadedLevel loaded = tutorial();
  loaded.level.bake.texel = 0.25;
  const Costs costs = costsAgainst(bakedWith(loaded.scene(), 64), loaded.scene());
  EXPECT_LE(costs.ofAuto.levelsRms, costs.of16.levelsRms);
  EXPECT_LE(2 * costs.ofAuto.tests, 3 * costs.of1.tests);
}

}  // namespace
}  // namespace hearth
