// Samples per texel: what more of them give, and what they cost.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "light/bakery.h"
#include "light/parallel.h"
#include "load/load.h"

namespace hearth {
namespace {

BakedLight bakedWith(const Level& level, std::optional<int> samples) {
  BakeSettings settings = level.bake;
  settings.samples = samples;
  return bake(level, settings, availableThreads());
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

TEST(Sampling, asShadowsNeedErrsLessThan16SamplesForTheCostOfOneAndAHalf) {
  const LoadResult result = loadLevel(HEARTH_SOURCE_DIR "/levels/tutorial.json");
  ASSERT_TRUE(result.loaded);
  Level level = result.loaded->level;
  for (LightSource& light : level.lights) light.radius = 0;  // balls have many rays to a sample
  const BakedLight exact = bakedWith(level, 196);
  const auto measure = [&](std::string_view name, std::optional<int> samples) {
    const BakedLight light = bakedWith(level, samples);
    const double error = rmsBetween(light, exact);
    fmt::print("{:>4} samples: {:.3f} levels rms, {} rays\n", name, error, light.stats.rays);
    return std::pair(error, static_cast<double>(light.stats.rays));
  };
  const auto [errorOf1, raysOf1] = measure("1", 1);
  const auto [errorOf4, raysOf4] = measure("4", 4);
  const auto [errorOf16, raysOf16] = measure("16", 16);
  const auto [errorOfAuto, raysOfAuto] = measure("auto", std::nullopt);
  EXPECT_LT(errorOf4, errorOf1);
  EXPECT_LT(errorOf16, errorOf4);
  EXPECT_EQ(raysOf16, 16 * raysOf1);
  EXPECT_LE(errorOfAuto, errorOf16);
  EXPECT_LE(raysOfAuto, 1.5 * raysOf1);
}

}  // namespace
}  // namespace hearth
