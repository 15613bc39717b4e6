// What the keys of a lights file do to the light that is baked, against values worked out by hand.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::sectorText;

std::string roomWith(std::string_view more) {
  return fmt::format("{{'light': 0, 'sectors': {{{}}}}}",
                     sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3, "{'texture':'#808080'}", more));
}

TEST(LightKeys, lambertMultipliesByTheCosineAtEverySurface) {
  const Vec3 light{2, 1.5, 2};
  // The floor rises from 0 at y = 0 to 1 at y = 4.
  const BakedRoom room(
      roomWith(",'slopeFloor':{'z':[0,0,1,1],'sidewall':'#808080'}"),
      "{'lights':[{'x':2,'y':1.5,'z':2,'intensity':200}],'bake':{'lambert':true}}");
  const double steep = std::sqrt(17.0);
  for (const auto& [kind, p, normal] :
       {std::tuple{SurfaceKind::Ceiling, Vec3{4, 3, 3}, Vec3{0, 0, -1}},
        std::tuple{SurfaceKind::Solid, Vec3{0, 2.5, 1.5}, Vec3{1, 0, 0}},
        std::tuple{SurfaceKind::Solid, Vec3{3.2, 4, 1.5}, Vec3{0, -1, 0}},
        std::tuple{SurfaceKind::SlopeFloor, Vec3{4, 2, 0.5}, Vec3{0, -1 / steep, 4 / steep}}}) {
    const Vec3 toLight = light - p;
    EXPECT_NEAR(room.at(kind, p), 200 * dot(toLight, normal) / length(toLight), 1) << name(kind);
  }
}

TEST(LightKeys, aBallWhoseMiddleLiesInAPlaneDoesNotLightIt) {
  const BakedRoom room(roomWith(""), "[{'x':3,'y':2,'z':0,'radius':0.5}]");
  EXPECT_EQ(room.at(SurfaceKind::Floor, {4, 3, 0}), 0);
  EXPECT_GT(room.at(SurfaceKind::Ceiling, {4, 3, 3}), 100);
}

/// Metres under a light 2 m above the floor.
double alongFloor(double distance) { return std::sqrt(distance * distance - 4); }

TEST(LightKeys, aCurveIsStraightBetweenItsPointsAndConstantPastThem) {
  const BakedRoom room(roomWith(""), "[{'x':0.5,'y':2,'z':2,'curve':[[2.2,200],[3,120],[4,80]]}]");
  const auto at = [&](double distance) {
    return room.at(SurfaceKind::Floor, {0.5 + alongFloor(distance), 2, 0});
  };
  EXPECT_EQ(at(2.05), 200);
  EXPECT_NEAR(at(2.6), 160, 1);
  EXPECT_NEAR(at(3.5), 100, 1);
  EXPECT_EQ(at(4.3), 80);
  EXPECT_EQ(at(5.5), 80);
}

TEST(LightKeys, twoPointsOfACurveAtOneDistanceMakeAJump) {
  const BakedRoom room(roomWith(""), "[{'x':0.5,'y':2,'z':2,'curve':[[0,200],[3,200],[3,50]]}]");
  const auto at = [&](double x) { return room.at(SurfaceKind::Floor, {0.5 + x, 2, 0}); };
  EXPECT_EQ(at(alongFloor(3) - 0.2), 200);
  EXPECT_EQ(at(alongFloor(3) + 0.2), 50);
}

/// A wall ends at x = 3, in line with texels' sides, and the light right above its end: the floor
/// beyond is dark up to that line and lit from there on.
TEST(LightKeys, samplesLieInsideTheirTexel) {
  const std::string rooms =
      fmt::format("{{'light': 0, 'sectors': {{{}, {}}}}}",
                  sectorText("north", "0,0, 6,0, 6,2, 3,2, 0,2", 0, 3,
                             "[{'texture':'#808080'},{'texture':'#808080'},"
                             "{'next':'south','texture':'#808080'},{'texture':'#808080'},"
                             "{'texture':'#808080'}]"),
                  sectorText("south", "0,2, 3,2, 6,2, 6,4, 0,4", 0, 3,
                             "[{'texture':'#808080'},{'next':'north','texture':'#808080'},"
                             "{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'}]"));
  for (const std::string_view samples : {"1", "4", "16", "64"}) {
    const BakedRoom baked(rooms, fmt::format("{{'lights':[{{'x':3,'y':1,'z':1,'intensity':200}}],"
                                             "'bake':{{'samples':{},'texel':0.25}}}}",
                                             samples));
    const Lightmap& floor =
        *baked.light().lightmaps[baked.surfaceAt(SurfaceKind::Floor, {4, 3, 0}, "south")->index()];
    for (int j = 9; j < 15; ++j) {
      EXPECT_EQ(floor.at(11, j), 0) << samples;
      EXPECT_EQ(floor.at(12, j), 200) << samples;
    }
  }
}

}  // namespace
}  // namespace hearth
