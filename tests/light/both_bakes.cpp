#include "both_bakes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <optional>
#include <utility>

#include "light/baking/baked_surface.h"
#include "random_levels/random_level.h"

namespace hearth::test {

namespace {

void add(const LightCost& cost, LightCost& sum) {
  sum.samples += cost.samples;
  sum.seenSamples += cost.seenSamples;
  sum.rays += cost.rays;
}

void print(const char* what, const BothCosts& costs) {
  fmt::print("{}: {} samples of lights, {} rays instead of {}\n", what, costs.byShafts.samples,
             costs.byShafts.rays, costs.byRays.rays);
}

/// With suns as points, and without areas, which have no rays.
LoadedLevel withPoints(LoadedLevel loaded) {
  std::erase_if(loaded.level.lights, [](const LightSource& light) { return light.isArea(); });
  for (LightSource& light : loaded.level.lights)
    if (light.sun) light.sun.emplace(light.sun->angle(), light.sun->pitch(), 0);
  return loaded;
}

}  // namespace

RandomLevels::RandomLevels()
    : folder_(std::filesystem::temp_directory_path() / fmt::format("hearth-beams-{}", ::getpid())) {
  EXPECT_TRUE(writeRandomLevelTextures(folder_ / "textures"));
}

RandomLevels::~RandomLevels() { std::filesystem::remove_all(folder_); }

LoadedLevel RandomLevels::level(std::uint64_t seed) const {
  const RandomLevel random = makeRandomLevel(seed);
  EXPECT_TRUE(writeRandomLevel(folder_, random));
  LoadResult result = loadLevel(folder_ / (random.name + ".json"));
  EXPECT_TRUE(result.loaded) << seed;
  return *std::move(result.loaded);
}

LoadedLevel withBalls(LoadedLevel loaded, std::uint64_t seed) {
  std::vector<LightSource>& lights = loaded.level.lights;
  for (std::size_t i = seed % 2; i < lights.size(); i += 2)
    lights[i].radius = 0.03 + 0.11 * static_cast<double>((i + seed) % 5);
  return loaded;
}

void expectSameBakes(const Scene& scene, const BakeSettings& settings, const std::string& what,
                     BothCosts& costs) {
  const LitSurfaces surfaces = makeLitSurfaces(scene, settings.texel);
  const LightVisibilities visibilities(scene, settings);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i]) continue;
    SCOPED_TRACE(fmt::format("{}, surface {}", what, i));
    const auto baked = [&](VisibilityMethod method, LightCost& cost) {
      BakeProgress progress;
      SurfaceLight surface(scene, surfaces, visibilities, settings.lambert, SurfaceId(i), method);
      std::optional<Lightmap> map = bakeSurface(surface, surfaces[i]->texels, settings, progress);
      for (const LightCost& light : surface.costs()) add(light, cost);
      return map;
    };
    LightCost byShafts;
    LightCost byRays;
    const std::optional<Lightmap> withShafts = baked(VisibilityMethod::Shafts, byShafts);
    const std::optional<Lightmap> withRays = baked(VisibilityMethod::RaysOnly, byRays);
    ASSERT_EQ(withShafts.has_value(), withRays.has_value());
    if (withShafts) {
      ASSERT_EQ(withShafts->channels, withRays->channels);
      ASSERT_EQ(withShafts->levels, withRays->levels);
    }
    ASSERT_EQ(byShafts.samples, byRays.samples);
    ASSERT_EQ(byShafts.seenSamples, byRays.seenSamples);
    add(byShafts, costs.byShafts);
    add(byRays, costs.byRays);
  }
}

void expectSameRandomBakes(std::uint64_t first, std::uint64_t last) {
  const RandomLevels levels;
  constexpr std::array<std::optional<int>, 4> kSamples = {1, 4, 9, std::nullopt};
  BothCosts points;
  BothCosts balls;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const LoadedLevel loaded = levels.level(seed);
    BakeSettings settings = loaded.level.bake;
    settings.texel = 0.5;
    settings.softSamples = 16;
    settings.samples = kSamples[seed % kSamples.size()];
    expectSameBakes(withPoints(loaded).scene(), settings, fmt::format("seed {}", seed), points);
    expectSameBakes(withBalls(loaded, seed / 4).scene(), settings,
                    fmt::format("seed {} with balls", seed), balls);
    if (testing::Test::HasFatalFailure()) return;
  }
  print("points", points);
  print("balls ", balls);
  EXPECT_LT(2 * points.byShafts.rays, points.byRays.rays);
  EXPECT_LT(3 * balls.byShafts.rays, 4 * balls.byRays.rays);
}

}  // namespace hearth::test
