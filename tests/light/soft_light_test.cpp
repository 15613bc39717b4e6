// Balls of light: which fraction of them a point sees.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "light/baking/light_visibility.h"
#include "support/baked_room.h"
#include "support/level_text.h"

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
