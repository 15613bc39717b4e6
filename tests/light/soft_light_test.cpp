// Balls of light: which fraction of them a point sees.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "light/baking/light_visibility.h"
#include "light/sampling/sample_placement.h"
#include "math/tolerance.h"
#include "random_levels/random_level.h"
#include "support/baked_room.h"
#include "support/level_text.h"
#include "truth/truth_light.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::levelFrom;
using test::sectorText;

constexpr std::string_view kSolid = "{'texture':'#808080'}";

/// Two halls that meet at x = 5. Up to y = 10 a wall stands between them; beyond, the eastern floor
/// is 20 m higher. So a ball of light in the west is seen past an upright edge, or over a level
/// one.
LoadedLevel halls(Vec3 light, double radius) {
  const std::string level = fmt::format(
      "{{'light': 0, 'sectors': {{{}, {}}}}}",
      sectorText("west", "0,0, 5,0, 5,10, 5,30, 0,30", 0, 60,
                 fmt::format("[{0},{0},{{'next':'east','texture':'#808080'}},{0},{0}]", kSolid)),
      sectorText("east", "5,10, 5,0, 20,0, 20,30, 5,30", 20, 60,
                 fmt::format("[{0},{0},{0},{0},{{'next':'west','texture':'#808080'}}]", kSolid)));
  return levelFrom(level, fmt::format("[{{'x':{},'y':{},'z':{},'sector':'west','radius':{}}}]",
                                      light.x, light.y, light.z, radius));
}

/// Of a ball's volume, what lies before a plane at a distance from its middle of t radii.
double fractionBefore(double t) {
  const double c = std::clamp(t, -1.0, 1.0);
  return (2 + 3 * c - c * c * c) / 4;
}

/// The far wall of the eastern hall.
LightTarget farWallPoint(double y, double z) {
  return {{20, y, z}, SectorId(1), {{20, y, z}, {-1, 0, 0}}};
}

/// In levels of 255.
struct Error {
  double greatest = 0;
  double rms = 0;
};

/// Over points of the far wall from which the ball is seen to rise past the edge.
Error errorAt(const LoadedLevel& loaded, int softSamples, bool isUpright) {
  const LightSource& light = loaded.level.lights[0];
  const LightVisibility visibility(loaded.scene(), light, softSamples);
  Error error;
  int points = 0;
  for (double along = 0.1; along < 19; along += 0.0837) {
    const LightTarget target = isUpright ? farWallPoint(along, 42) : farWallPoint(29, 20 + along);
    // The line from the point through the edge, on the map or upright beside it.
    const Vec2 edge = isUpright ? Vec2{5, 10} : Vec2{5, 20};
    const Vec2 from = isUpright ? target.point.xy() : Vec2{20, target.point.z};
    const Vec2 ball = isUpright ? light.position.xy() : Vec2{light.position.x, light.position.z};
    const double before = -cross(edge - from, ball - from) / length(edge - from);
    const double exact = fractionBefore(before / light.radius);
    if (exact == 0 || exact == 1) continue;
    std::int64_t rays = 0;
    const double wrong = 255 * std::abs(visibility.seenFraction(target, rays) - exact);
    error.greatest = std::max(error.greatest, wrong);
    error.rms += wrong * wrong;
    ++points;
  }
  error.rms = std::sqrt(error.rms / points);
  return error;
}

TEST(SoftLight, isTheFractionOfABallsVolumeBesideAnEdge) {
  for (const double radius : {0.2, 1.0, 2.0})
    for (const bool isUpright : {true, false}) {
      const LoadedLevel loaded =
          isUpright ? halls({2.1, 12, 41}, radius) : halls({2.1, 25, 18}, radius);
      Error before;
      for (const int samples : {16, 36, 64, 256}) {
        const Error error = errorAt(loaded, samples, isUpright);
        fmt::print("{} edge, ball of {} m, {:3} samples: {:.3f} levels at most, rms {:.3f}\n",
                   isUpright ? "upright" : "level", radius, samples, error.greatest, error.rms);
        EXPECT_LE(error.greatest, samples < 36 ? 2 : 1);
        if (samples == 64 || samples == 256) {
          EXPECT_LE(error.rms, before.rms / 2) << "as 1/sqrt(samples) at least";
        }
        if (samples != 36) before = error;
      }
    }
}

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
  for (std::size_t i = 0; i < level.lights.size(); ++i) {
    level.lights[i].radius = 0.1 + 0.13 * static_cast<double>(i % 4);
    level.lights[i].intensity = 255;
    level.lights[i].falloff = 0;
    level.lights[i].curve.clear();
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

TEST(SoftLight, ofABallThatItsCeilingCutsIsThatOfTheRest) {
  // The middle is 0.1 m under the ceiling, so of a ball of 0.4 m what lies over t = 0.25 is cut
  // off.
  const LoadedLevel loaded = levelFrom(fmt::format("{{'light': 0, 'sectors': {{{}}}}}",
                                                   sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3)),
                                       "[{'x':3,'y':2,'z':2.9,'radius':0.4}]");
  const Plane floor{{0, 0, 0}, {0, 0, 1}};
  const Plane wall{{6, 0, 0}, {-1, 0, 0}};
  for (const auto& [samples, bound] : {std::pair{36, 2.0}, std::pair{256, 1.0}}) {
    const LightVisibility visibility(loaded.scene(), loaded.level.lights[0], samples);
    for (const auto& [p, plane] :
         {std::pair{Vec3{2.5, 1, 0}, floor}, std::pair{Vec3{6, 1.3, 0.7}, wall},
          std::pair{Vec3{6, 1.3, 2.6}, wall}, std::pair{Vec3{6, 2.0, 2.9}, wall}}) {
      std::int64_t rays = 0;
      EXPECT_NEAR(255 * visibility.seenFraction({p, SectorId(0), plane}, rays),
                  255 * fractionBefore(0.25), bound)
          << samples << " samples, " << p.x << " " << p.z;
    }
  }
}

TEST(SoftLight, ofABallThatTheFloorCutsIsThatOfTheRestOnTheFloorToo) {
  const std::string room = fmt::format("{{'light': 0, 'sectors': {{{}}}}}",
                                       sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3));
  for (const double z : {0.05, 0.1, 0.2, 0.35}) {
    const BakedRoom baked(
        room, fmt::format("{{'lights':[{{'x':3,'y':2,'z':{},'intensity':200,'radius':0.5}}],"
                          "'bake':{{'texel':0.5}}}}",
                          z));
    for (double x = 0.25; x < 6; x += 0.5)
      EXPECT_NEAR(baked.at(SurfaceKind::Floor, {x, 1.25, 0}), 200 * fractionBefore(z / 0.5), 1.5)
          << x;
  }
}

TEST(SoftLight, comesThroughAPortalThatTheBallReachesInto) {
  const std::string rooms = fmt::format(
      "{{'light': 0, 'sectors': {{{}, {}}}}}",
      sectorText("west", "0,0, 6,0, 6,4, 0,4", 0, 3,
                 fmt::format("[{0},{{'next':'east','texture':'#808080'}},{0},{0}]", kSolid)),
      sectorText("east", "6,0, 9,0, 9,4, 6,4", 0, 3,
                 fmt::format("[{0},{0},{0},{{'next':'west','texture':'#808080'}}]", kSolid)));
  const BakedRoom baked(rooms,
                        "{'lights':[{'x':5.9,'y':2,'z':1.5,'intensity':200,'radius':0.5,'sector':'"
                        "west'}],'bake':{'texel':0.5}}");
  EXPECT_EQ(baked.at(SurfaceKind::Solid, {9, 2, 1.5}, "east"), 200);
  EXPECT_EQ(baked.at(SurfaceKind::Solid, {0, 2, 1.5}, "west"), 200);
}

}  // namespace
}  // namespace hearth
