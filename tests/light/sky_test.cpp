// The light of the sky, as it is baked.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "light/bakery.h"
#include "light/gather/area_visibility.h"
#include "light/gather/light_lattice.h"
#include "support/baked_room.h"
#include "support/form_factor.h"
#include "support/in_tree.h"
#include "support/level_text.h"
#include "support/models.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::factorOverCorner;
using test::levelFrom;
using test::sectorText;

/// Level ground under the sky.
std::string underSky(std::string_view name, std::string_view vertices, double height,
                     std::string_view walls = "{'texture':'#808080'}") {
  return fmt::format(
      "'{}':{{'floor':{{'texture':'#808080'}},"
      "'ceiling':{{'z':{},'texture':'sky','parallax':true}},"
      "'loops':{{'border':{{'v':[{}],'walls':{}}}}}}}",
      name, height, vertices, walls);
}

/// Of some walls, one of which leads to another sector.
std::string wallsTo(std::string_view next, int portal, int count = 4) {
  std::string walls;
  for (int i = 0; i < count; ++i)
    walls += fmt::format("{}{{{}'texture':'#808080'}}", i == 0 ? "" : ",",
                         i == portal ? fmt::format("'next':'{}',", next) : "");
  return fmt::format("[{}]", walls);
}

std::string levelText(std::string_view sectors, std::string_view things = "") {
  return fmt::format("{{'light':0,'textures':'{}','sectors':{{{}}},'things':[{}]}}",
                     test::inTree("textures").string(), sectors, things);
}

std::string skyText(double intensity, std::string_view more = "", std::string_view bake = "{}") {
  return fmt::format("{{'lights':[],'sky':{{'intensity':{}{}}},'bake':{}}}", intensity, more, bake);
}

/// The fraction of a sky at a point of a floor.
double onFloor(const LoadedLevel& loaded, Vec3 p) {
  AreaVisibility areas(loaded.scene(), false);
  double fraction = 0;
  std::int64_t slices = 0;
  areas.findOnSurface(p, SectorId(0), {0, 0, 1}, {&fraction, 1}, slices);
  return fraction;
}

TEST(Sky, GivesLevelGroundInTheOpenItsIntensity) {
  const LoadedLevel loaded = levelFrom(
      levelText(underSky("plain", "-500,-500, 500,-500, 500,500, -500,500", 0.001)), skyText(120));
  EXPECT_NEAR(onFloor(loaded, {0, 0, 0}), 1, 1e-9);
  EXPECT_NEAR(onFloor(loaded, {499, -499.5, 0}), 1, 1e-5);
}

TEST(Sky, ThroughAShaftHasTheFormFactorOfItsOpening) {
  for (const double height : {0.5, 2.0, 10.0}) {
    const LoadedLevel loaded =
        levelFrom(levelText(underSky("shaft", "0,0, 2,0, 2,3, 0,3", height)), skyText(100));
    for (const Vec2 p : {Vec2{1, 1.5}, Vec2{0.5, 1}, Vec2{0.01, 2.9}}) {
      const double opening =
          factorOverCorner(p.x, p.y, height) + factorOverCorner(2 - p.x, p.y, height) +
          factorOverCorner(p.x, 3 - p.y, height) + factorOverCorner(2 - p.x, 3 - p.y, height);
      EXPECT_NEAR(onFloor(loaded, {p.x, p.y, 0}), opening, 0.003) << height;
    }
  }
}

/// Of 0.2 m, as high as the room, to a plain. Lines through it rise to the sky.
TEST(Sky, IsSeenThroughHoweverNarrowAWindow) {
  constexpr double kIntensity = 2550;
  const LoadedLevel loaded =
      levelFrom(levelText(sectorText("room", "-8,-8, 8,-8, 8,-0.1, 8,0.1, 8,8, -8,8", 0, 3,
                                     wallsTo("plain", 2, 6)) +
                          "," +
                          underSky("plain", "8,-0.1, 8,-999, 999,-999, 999,999, 8,999, 8,0.1", 3,
                                   wallsTo("room", 5, 6))),
                skyText(kIntensity));
  for (double x = 0; x < 7; x += 0.9)
    for (double y = -7; y < 7; y += 0.61) {
      const double width = std::atan2(0.1 - y, 8 - x) - std::atan2(-0.1 - y, 8 - x);
      const double square = (8 - x) * (8 - x) + y * y;
      const double seen = width / (2 * std::numbers::pi) * 9 / (square + 9);
      EXPECT_NEAR(onFloor(loaded, {x, y, 0}), seen, 1 / kIntensity + 0.04 * seen) << x << ' ' << y;
    }
}

/// In a shaft, where the light of the sky is uneven.
TEST(Sky, TakesFewerSlicesTheFartherOffItMayBe) {
  const LoadedLevel loaded =
      levelFrom(levelText(underSky("shaft", "0,0, 4,0, 4,3, 0,3", 4)), skyText(250));
  std::vector<std::int64_t> slices;
  std::vector<double> floors;
  for (const double gatherError : {0.25, 1.0, 4.0}) {
    const BakedLight light = bake(loaded.scene(), {.gatherError = gatherError}, 1);
    slices.push_back(light.lightCosts.at(0).rays);
    floors.push_back(light.lightmaps.at(0)->at(4, 5));
  }
  EXPECT_GT(slices[0], 2 * slices[1]);
  EXPECT_GT(slices[1], 2 * slices[2]);
  EXPECT_NEAR(floors[1], floors[0], 2);
  EXPECT_NEAR(floors[2], floors[0], 6);
}

TEST(Sky, LightsWallsByHalfOfItAtMostAndCeilingsNot) {
  const BakedRoom room(
      levelText(underSky("yard", "0,0, 200,0, 200,200, 0,200", 4, "{'texture':'#808080'}")),
      skyText(200, ",'color':'#ff8000'", "{'texel':0.5}"));
  EXPECT_NEAR(room.at(SurfaceKind::Floor, {100, 100, 0}), 200, 1);
  EXPECT_NEAR(room.at(SurfaceKind::Floor, {100, 100, 0}, "", 1), 200 * 128 / 255.0, 1);
  EXPECT_EQ(room.at(SurfaceKind::Floor, {100, 100, 0}, "", 2), 0);
  EXPECT_NEAR(room.at(SurfaceKind::Solid, {0, 100, 3.5}), 100, 2);
}

TEST(AreaVisibility, TakesNoSlicesInALevelWithoutAreas) {
  const LoadedLevel loaded =
      levelFrom(levelText(underSky("plain", "-5,-5, 5,-5, 5,5, -5,5", 2)), "{'lights':[]}");
  AreaVisibility areas(loaded.scene(), false);
  std::int64_t slices = 0;
  areas.findOnSurface({0, 0, 0}, SectorId(0), {0, 0, 1}, {}, slices);
  areas.findFromAir({0, 0, 1}, SectorId(0), {}, slices);
  EXPECT_EQ(slices, 0);
}

TEST(Sky, WhateverLambertSaysHasTheCosine) {
  const std::string yard = levelText(underSky("yard", "0,0, 8,0, 8,8, 0,8", 3));
  const BakedRoom with(yard, skyText(200, "", "{'lambert':true}"));
  const BakedRoom without(yard, skyText(200));
  for (const Vec3 p : {Vec3{4, 4, 0}, Vec3{1, 7, 0}})
    EXPECT_EQ(with.at(SurfaceKind::Floor, p), without.at(SurfaceKind::Floor, p));
}

TEST(Sky, IsDarkInARoomWithoutSky) {
  const BakedRoom room(levelText(sectorText("room", "0,0, 8,0, 8,8, 0,8", 0, 3)), skyText(200));
  for (const auto& map : room.light().lightmaps) EXPECT_FALSE(map);
}

/// Two rooms of which walls stand back to back.
TEST(Sky, DoesNotLeakThroughThinWalls) {
  const BakedRoom room(levelText(sectorText("room", "0,0, 8,0, 8,8, 0,8", 0, 3) + "," +
                                 underSky("yard", "8,0, 16,0, 16,8, 8,8", 3)),
                       skyText(255));
  EXPECT_EQ(room.at(SurfaceKind::Floor, {7.95, 4, 0}, "room"), 0);
  EXPECT_EQ(room.at(SurfaceKind::Solid, {8, 4, 2.9}, "room"), 0);
  EXPECT_GT(room.at(SurfaceKind::Solid, {8, 4, 2.9}, "yard"), 100);
}

/// Half of them end in an endless sky, and half of these in front of a wall.
TEST(Sky, AtPointsOfTheAirComesFromAllDirections) {
  const LoadedLevel loaded =
      levelFrom(levelText(underSky("plain", "0,0, 2000,0, 2000,2000, 0,2000", 2.5)), skyText(255));
  AreaVisibility areas(loaded.scene(), false);
  double fraction = 0;
  std::int64_t slices = 0;
  areas.findFromAir({1000, 1000, 2}, SectorId(0), {&fraction, 1}, slices);
  EXPECT_NEAR(fraction, 0.5, 0.001);
  areas.findFromAir({1e-6, 1000, 2}, SectorId(0), {&fraction, 1}, slices);
  EXPECT_NEAR(fraction, 0.25, 0.001);
}

/// Posts stand on a box wherever a coarse lattice would ask, as boards do on crates.
TEST(Sky, LightsWhatLiesBetweenPlacesInsideOfMeshes) {
  std::string things = "{'mesh':'box.obj','x':0,'y':0}";
  for (const double x : {-0.5, -0.3125, 0.0625, 0.3125, 0.5})
    for (const double y : {-0.5, -0.3125, 0.0625, 0.3125, 0.5})
      things +=
          fmt::format(",{{'mesh':'box.obj','x':{},'y':{},'z':0.9,'scale':[0.1,0.1,0.2]}}", x, y);
  const std::string level =
      levelText(underSky("yard", "-50,-50, 50,-50, 50,50, -50,50", 2), things);
  const BakedRoom room(
      levelFrom(level, skyText(200, "", "{'texel':0.125}"), {{"box.obj", test::kBoxModel}}));
  EXPECT_EQ(room.onMesh({0.0625, 0.0625, 1}, {0, 0, 1}), 0) << "inside of a post";
  EXPECT_GT(room.onMesh({-0.1875, -0.1875, 1}, {0, 0, 1}), 50);
}

/// On the ground beside a box of 1 m, on the box, and inside of what it covers.
TEST(Sky, IsHiddenByMeshesAndLightsThem) {
  const std::string level = levelText(underSky("yard", "-50,-50, 50,-50, 50,50, -50,50", 2),
                                      "{'mesh':'box.obj','x':0,'y':0}");
  const BakedRoom room(
      levelFrom(level, skyText(200, "", "{'texel':0.1}"), {{"box.obj", test::kBoxModel}}));
  EXPECT_NEAR(room.onMesh({0, 0, 1}, {0, 0, 1}), 200, 6);
  EXPECT_NEAR(room.onMesh({0.5, 0, 0.5}, {1, 0, 0}), 97, 4);
  const double beside = room.at(SurfaceKind::Floor, {0.55, 0, 0});
  EXPECT_GT(beside, 100);
  EXPECT_LT(beside, 130) << "half of the sky is behind the box, but for what is beside it";
  EXPECT_GT(room.at(SurfaceKind::Floor, {5, 0, 0}), 195);
}

/// Beside a yard whose sky is low: what comes over that is sky, too.
TEST(Sky, IsSeenThroughTheStepBetweenTwoSkyCeilings) {
  const auto fractionAt = [&](double height) {
    return onFloor(
        levelFrom(levelText(underSky("high", "0,0, 8,0, 8,8, 0,8", 8, wallsTo("low", 1)) + "," +
                            underSky("low", "8,0, 9,0, 9,8, 8,8", height, wallsTo("high", 3))),
                  skyText(100)),
        {7.9, 4, 0});
  };
  EXPECT_GT(fractionAt(1), fractionAt(8) + 0.2) << "the wall beyond the low yard hides less";
}

TEST(Sky, HasNoSeamWhereAFloorIsCut) {
  const BakedRoom whole(levelText(underSky("yard", "0,0, 14.2,0, 14.2,8, 0,8", 3)), skyText(255));
  const BakedRoom cut(
      levelText(underSky("west", "0,0, 6.3,0, 6.3,8, 0,8", 3, wallsTo("east", 1)) + "," +
                underSky("east", "6.3,0, 14.2,0, 14.2,8, 6.3,8", 3, wallsTo("west", 3))),
      skyText(255));
  for (double x = 6; x < 6.6; x += 0.05)
    for (double y = 0.3; y < 8; y += 0.7) {
      const std::string_view sector = x < 6.3 ? "west" : "east";
      EXPECT_NEAR(cut.at(SurfaceKind::Floor, {x, y, 0}, sector),
                  whole.at(SurfaceKind::Floor, {x, y, 0}), 1.5)
          << x << ' ' << y;
    }
}

TEST(LightLattice, InterpolatesWhatIsEvenAndDividesWhereItIsNot) {
  int asked = 0;
  const auto step = [&](int i, int, std::span<double> values) {
    ++asked;
    values[0] = 3 + 0.01 * (i + 0.5);
    values[1] = i < 40 ? 0 : 1;
    return true;
  };
  const TexelRect texels{-7, 3, 100, 50};
  LightLattice lattice(texels, {16, 0, true}, {0.1, 0.1}, step);
  for (double y = 3; y <= 53; y += 3.7)
    for (double x = -6.5; x <= 92.5; x += 1.3) {
      EXPECT_NEAR(lattice.at({x, y}, 0), 3 + 0.01 * x, 1e-12);
      if (x < 39.5 || x > 40.5) {
        EXPECT_EQ(lattice.at({x, y}, 1), x < 40 ? 0 : 1) << x;
      }
    }
  EXPECT_LT(asked, 100 * 50 / 4);
  EXPECT_NEAR(lattice.at({-100, 20}, 0), lattice.at({-6.5, 20}, 0), 0) << "the nearest";
}

TEST(LightLattice, HasAllTexelsBesideAStepAndNoNodesBetweenTexels) {
  std::vector<std::array<int, 2>> asked;
  const auto isBeyond = [](int i, int j) { return 3 * i + j > 40; };
  const auto step = [&](int i, int j, std::span<double> values) {
    asked.push_back({i, j});
    values[0] = isBeyond(i, j) ? 1 : 0;
    return true;
  };
  LightLattice lattice({5, -2, 16, 13}, {16, 0, true}, {0.1}, step);
  for (int j = -2; j < 11; ++j)
    for (int i = 5; i < 21; ++i)
      EXPECT_EQ(lattice.at({i + 0.5, j + 0.5}, 0), isBeyond(i, j) ? 1 : 0) << i << ' ' << j;
  EXPECT_LT(asked.size(), 16U * 13U);
  std::ranges::sort(asked);
  EXPECT_EQ(std::ranges::adjacent_find(asked), asked.end()) << "asked twice";
}

/// Of two cells on either side of a line of texels one may be divided there, and the other not.
TEST(LightLattice, LetsNoRoundingChooseTheCellOfATexel) {
  const auto fringe = [](int i, int j, std::span<double> values) {
    const bool isBright = i == 8 ? j == 5 : i > 8 && j >= 3;
    values[0] = isBright ? 1 : 0;
    return true;
  };
  for (const double off : {-1e-8, 0.0, 1e-8}) {
    LightLattice lattice({0, 0, 17, 17}, {16, 0, true}, {0.1}, fringe);
    EXPECT_EQ(lattice.at({8.5 + off, 5.5}, 0), 1) << off;
  }
}

TEST(LightLattice, HasOneLineOfNodesAlongWhatIsNarrow) {
  const auto ramp = [](int i, int j, std::span<double> values) {
    EXPECT_EQ(j, 8);
    values[0] = i + 0.5;
    return true;
  };
  LightLattice lattice({3, 7, 60, 4}, {32, 4, true}, {0.1}, ramp);
  for (const double x : {3.5, 20.25, 62.5})
    for (const double y : {7.0, 8.5, 11.0}) EXPECT_NEAR(lattice.at({x, y}, 0), x, 1e-12);
}

TEST(LightLattice, TakesNothingFromWhereThereIsNoLight) {
  const auto hole = [&](int i, int, std::span<double> values) {
    values[0] = i < 20 ? 1 : -1000;
    return i < 20;
  };
  LightLattice lattice({0, 0, 40, 8}, {16, 0, true}, {0.1}, hole);
  for (double x = 0; x < 20; x += 0.5) EXPECT_EQ(lattice.at({x, 4}, 0), 1) << x;
  EXPECT_EQ(lattice.at({30, 4}, 0), 0);
}

}  // namespace
}  // namespace hearth
