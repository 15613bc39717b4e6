// Which fraction of a spherical light a point of a random level sees, against truth.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "light/baking/light_visibility.h"
#include "light/sampling/sample_placement.h"
#include "load/load.h"
#include "math/tolerance.h"
#include "random_levels/random_level.h"
#include "truth/truth_light.h"

namespace hearth {
namespace {

/// Texel centres well inside their surfaces, a few of a level.
std::vector<SamplePoint> placesOn(const Scene& scene, const LitSurfaces& surfaces) {
  std::vector<SamplePoint> places;
  const std::vector<SurfaceId> shown = scene.shownSurfaces();
  for (std::size_t i = 0; i < shown.size(); i += 5) {
    const std::optional<LitSurface>& surface = surfaces[shown[i].index()];
    if (!surface) continue;
    const TexelRect rect = surface->texels;
    const Vec2 p{rect.i0 + rect.width / 2 + 0.5, rect.j0 + rect.height / 3 + 0.5};
    if (surface->outline.contains(p) && length(surface->outline.nearest(p) - p) > 0.1)
      places.push_back(SamplePlacement(surfaces, shown[i]).place(p));
  }
  return places;
}

/// All lights as balls of several sizes, 255 levels at any distance and angle.
LoadedLevel withBalls(LoadedLevel loaded) {
  Level& level = loaded.level;
  level.bake.lambert = false;
  std::erase_if(level.lights, [](const LightSource& light) { return !light.hasPlace(); });
  for (std::size_t i = 0; i < level.lights.size(); ++i) {
    level.lights[i].radius = 0.1 + 0.13 * static_cast<double>(i % 4);
    level.lights[i].intensity = 255;
    level.lights[i].falloff = 0;
    level.lights[i].curve.clear();
    level.lights[i].spot.reset();
  }
  return loaded;
}

/// In levels of 255, wherever a ball is seen in part.
void addErrors(const Scene& scene, int softSamples, std::vector<double>& errors) {
  const Level& level = scene.level();
  const TruthLight truth(level);
  const LitSurfaces surfaces = makeLitSurfaces(scene, 0.25);
  const std::vector<SamplePoint> places = placesOn(scene, surfaces);
  for (std::size_t light = 0; light < level.lights.size(); ++light) {
    const LightVisibility visibility(scene, level.lights[light], softSamples);
    for (const SamplePoint& at : places) {
      const Surface& surface = level[at.surface];
      const LitSurface& lit = *surfaces[at.surface.index()];
      if (std::abs(lit.distanceInFront(level.lights[light].position)) <= kInPlane) continue;
      std::int64_t rays = 0;
      const double found = 255 * visibility.seenFraction(
                                     {at.target, surface.sector, {lit.anchor, lit.normal}}, rays);
      const double exact =
          truth.from(light, {surface.kind, surface.sector, surface.segment, at.target, lit.normal});
      if (found != exact || (exact > 0 && exact < 255)) errors.push_back(std::abs(found - exact));
    }
  }
}

/// Of so many random levels, with or without masked middle textures: sorted.
std::vector<double> errorsOfRandomLevels(std::uint64_t firstSeed, int count, bool haveMiddles,
                                         int softSamples) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-soft-light-{}", ::getpid());
  EXPECT_TRUE(writeRandomLevelTextures(folder / "textures"));
  std::vector<double> errors;
  for (std::uint64_t seed = firstSeed; count > 0; ++seed) {
    const RandomLevel random = makeRandomLevel(seed);
    if (random.features.contains(Feature::MiddleTexture) != haveMiddles) continue;
    --count;
    EXPECT_TRUE(writeRandomLevel(folder, random));
    const LoadResult result = loadLevel(folder / (random.name + ".json"));
    EXPECT_TRUE(result.loaded) << seed;
    if (result.loaded) addErrors(withBalls(*result.loaded).scene(), softSamples, errors);
  }
  std::filesystem::remove_all(folder);
  std::ranges::sort(errors);
  return errors;
}

double quantile(const std::vector<double>& errors, double fraction) {
  return errors[static_cast<std::size_t>(fraction * static_cast<double>(errors.size() - 1))];
}

void print(const std::vector<double>& errors) {
  fmt::print(
      "{} partly seen balls: half within {:.2f} levels, 90 % within {:.2f}, 99 % within {:.2f}, "
      "all within {:.2f}\n",
      errors.size(), quantile(errors, 0.5), quantile(errors, 0.9), quantile(errors, 0.99),
      quantile(errors, 1));
}

/// What is narrower than a cell of the ball's disc, a slit or a post, can fall between its corners;
/// with more cells less does.
TEST(SoftLight, ofRandomLevelsIsThatOfTruthsManyPoints) {
  const auto errors = errorsOfRandomLevels(1, 24, false, BakeSettings{}.softSamples);
  print(errors);
  ASSERT_GE(errors.size(), 200U);
  EXPECT_LE(quantile(errors, 0.5), 0.5);
  EXPECT_LE(quantile(errors, 0.9), 2);
  EXPECT_LE(quantile(errors, 0.99), 3);
  const auto fineErrors = errorsOfRandomLevels(21, 4, false, 1024);
  ASSERT_GE(fineErrors.size(), 30U);
  EXPECT_LE(fineErrors.back(), 1.5);
}

/// The holes of a grille are many and narrow.
TEST(SoftLight, behindMiddleTexturesIsNearThatOfTruthsManyPoints) {
  const auto errors = errorsOfRandomLevels(1, 24, true, BakeSettings{}.softSamples);
  print(errors);
  ASSERT_GE(errors.size(), 200U);
  EXPECT_LE(quantile(errors, 0.5), 0.6);
  EXPECT_LE(quantile(errors, 0.9), 2.5);
  EXPECT_LE(quantile(errors, 0.99), 12);
}

}  // namespace
}  // namespace hearth
