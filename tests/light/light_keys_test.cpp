// What the keys of a lights file do to the light that is baked, against values worked out by hand.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

/// The largest difference of two bakes of a level, in levels.
int largestDifference(const BakedLight& a, const BakedLight& b) {
  int largest = 0;
  for (std::size_t s = 0; s < a.lightmaps.size(); ++s) {
    if (!a.surfaces[s]) continue;
    const TexelRect& rect = a.surfaces[s]->texels;
    const auto valueAt = [](const std::optional<Lightmap>& map, int i, int j) {
      return map ? map->at(i, j) : 0;
    };
    for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
      for (int i = rect.i0; i < rect.i0 + rect.width; ++i)
        largest = std::max(largest,
                           std::abs(valueAt(a.lightmaps[s], i, j) - valueAt(b.lightmaps[s], i, j)));
  }
  return largest;
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

TEST(LightKeys, spotLightsAConeOnly) {
  // 2 m above the floor, straight down: full up to 1 m from the middle, none beyond 2 m.
  for (const char* radius : {"0", "0.05"}) {
    const BakedRoom room(roomWith(""),
                         fmt::format("[{{'x':3,'y':2,'z':2,'intensity':200,'radius':{},"
                                     "'spot':{{'pitch':-90,'inner':26.565051177,'outer':45}}}}]",
                                     radius));
    const double inner = 2 / std::sqrt(5.0);
    const double outer = std::sqrt(0.5);
    for (const double away : {0.1, 0.6, 0.9, 1.2, 1.5, 1.8, 2.2, 2.6}) {
      const double cosine = 2 / std::hypot(2, away);
      const double t = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
      EXPECT_NEAR(room.at(SurfaceKind::Floor, {3 + away, 2, 0}), 200 * t * t * (3 - 2 * t), 2.5)
          << away;
    }
    EXPECT_EQ(room.at(SurfaceKind::Ceiling, {3.2, 2, 3}), 0);
    EXPECT_EQ(room.at(SurfaceKind::Solid, {3, 4, 2.5}), 0);
  }
}

TEST(LightKeys, aBallWhoseMiddleLiesInAPlaneDoesNotLightIt) {
  const BakedRoom room(roomWith(""), "[{'x':3,'y':2,'z':0,'radius':0.5}]");
  EXPECT_EQ(room.at(SurfaceKind::Floor, {4, 3, 0}), 0);
  EXPECT_GT(room.at(SurfaceKind::Ceiling, {4, 3, 3}), 100);
}

TEST(LightKeys, aBallWithoutSamplesIsAPoint) {
  const std::string wall = sectorText("room", "0,0, 6,0, 6,4, 3,4, 3,2, 2.9,2, 2.9,4, 0,4", 0, 3);
  const std::string level = "{'light': 0, 'sectors': {" + wall + "}}";
  const BakedRoom ball(level, "[{'x':1,'y':3,'z':2,'radius':0.5}]");
  const BakedRoom point(level, "[{'x':1,'y':3,'z':2}]");
  BakeSettings settings = ball.level().bake;
  settings.softSamples = 0;
  EXPECT_GT(largestDifference(ball.light(), point.light()), 50);
  for (const std::optional<int> samples : {std::optional(1), std::optional<int>()}) {
    settings.samples = samples;
    const BakedLight asPoint = bake(ball.scene(), settings, 2);
    EXPECT_EQ(largestDifference(asPoint, bake(point.scene(), settings, 2)), 0);
  }
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

LightSource withCurve(std::vector<CurvePoint> curve) {
  LightSource light;
  light.curve = std::move(curve);
  return light;
}

TEST(LightReach, endsWhereALightHasNoMoreThanSoManyLevels) {
  LightSource light;
  light.intensity = 200;
  light.falloff = 0.5;
  EXPECT_DOUBLE_EQ(light.reach(50), 6);  // 200 / (0.5 * 6 + 1) = 50
  EXPECT_EQ(light.reach(200), 0);
  EXPECT_TRUE(std::isinf(light.reach(0)));
  light.falloff = 0;
  EXPECT_TRUE(std::isinf(light.reach(199)));
  EXPECT_EQ(withCurve({{1, 100}, {3, 20}, {4, 20}}).reach(60), 2);
  EXPECT_TRUE(std::isinf(withCurve({{1, 100}, {3, 20}}).reach(10)));
}

TEST(LightReach, isThatOfACurvesLastPointWithLight) {
  EXPECT_EQ(withCurve({{1, 0}, {2, 100}, {3.1, 0}, {9, 0}}).reach(0), 3.1);
  EXPECT_EQ(withCurve({{1, 80}, {2, 80}, {2, 0}}).reach(0), 2) << "a jump";
  EXPECT_EQ(withCurve({{1, 0}, {2, 0}}).reach(0), 0);
}

TEST(LightReach, isThatOfTheBrightestChannel) {
  LightSource light;
  light.falloff = 1;
  light.color[0] = 51;
  light.color[1] = light.color[2] = 0;
  EXPECT_DOUBLE_EQ(light.reach(17), 2);  // 51 / (2 + 1)
  light.color[0] = 0;
  EXPECT_EQ(light.reach(0), 0);
}

TEST(Texels, areOffByHalfALevel) {
  for (const char* color : {"#ffffff", "#ff8040"}) {
    const BakedRoom room(
        roomWith(""), fmt::format("[{{'x':0.5,'y':2,'z':2,'falloff':0.5,'color':'{}'}}]", color));
    const BakedLight& baked = room.light();
    const LightSource& light = room.level().lights[0];
    double error = 0;
    for (std::size_t s = 0; s < baked.lightmaps.size(); ++s) {
      if (!baked.lightmaps[s]) continue;
      const LitSurface& surface = *baked.surfaces[s];
      for (int i = surface.texels.i0 + 2; i < surface.texels.i0 + surface.texels.width - 2; ++i) {
        const int j = surface.texels.j0 + 4;
        const double distance = length(surface.toWorld({i + 0.5, j + 0.5}) - light.position);
        const double exact = light.brightnessAt(distance) * light.colorFactor(2);
        error = std::max(error, std::abs(baked.lightmaps[s]->at(i, j, 2) - exact));
      }
    }
    EXPECT_GT(error, 0.3);
    EXPECT_LE(error, 0.5 + 1e-6);
  }
}

TEST(CutOff, losesNoMoreThanItsLevelsOfEachLight) {
  const BakedRoom exact(roomWith(""),
                        "[{'x':1,'y':2,'z':2,'falloff':2},{'x':5,'y':1,'z':1,'falloff':3}]");
  const auto lossAt = [&](double cutOff) {
    BakeSettings settings = exact.level().bake;
    settings.cutOff = cutOff;
    return largestDifference(exact.light(), bake(exact.scene(), settings, 2));
  };
  EXPECT_EQ(lossAt(0), 0);
  for (const int levels : {20, 30, 40}) {
    EXPECT_GT(lossAt(levels), levels / 2) << levels;
    EXPECT_LE(lossAt(levels), 2 * levels + 1) << levels;  // of two lights, and two roundings
  }
}

TEST(CutOff, savesTheWorkOfLightsThatAreLeftOut) {
  const BakedRoom exact(roomWith(""), "[{'x':0.5,'y':2,'z':2,'falloff':2}]");
  BakeSettings settings = exact.level().bake;
  settings.cutOff = 30;  // 3.75 m
  EXPECT_LT(bake(exact.scene(), settings, 2).lightCosts[0].samples,
            exact.light().lightCosts[0].samples);
}

}  // namespace
}  // namespace hearth
