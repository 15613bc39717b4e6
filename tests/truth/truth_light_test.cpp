#include "truth/truth_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "scenes.h"
#include "test_level.h"

namespace hearth {
namespace {

SurfacePoint floorPoint(SectorId sector, Vec3 point) {
  return {SurfaceKind::Floor, sector, std::nullopt, point, {0, 0, 1}};
}

SurfacePoint ceilingPoint(SectorId sector, Vec3 point) {
  return {SurfaceKind::Ceiling, sector, std::nullopt, point, {0, 0, -1}};
}

/// What white lights add up to: the same in every channel.
double whiteLevel(const TruthLight& light, const SurfacePoint& place) {
  const Vec3 levels = light.at(place);
  EXPECT_EQ(levels, (Vec3{levels.x, levels.x, levels.x}));
  return levels.x;
}

/// A point of wall 1 of a box: the one at xMax.
SurfacePoint eastWallPoint(const TestLevel& test, SectorId box, Vec3 point,
                           SurfaceKind kind = SurfaceKind::Solid) {
  return {kind, box, test.wallId(box, 1), point, {-1, 0, 0}};
}

TEST(TruthLight, FallsOffWithDistance) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {8, 8}, {0, 4});
  test.addLight(box, {4, 4, 3}, 200, 0.5);
  const TruthLight light(test.finished());
  EXPECT_NEAR(whiteLevel(light, floorPoint(box, {4, 4, 0})), 200 / (3 * 0.5 + 1), 1e-12);
  EXPECT_NEAR(whiteLevel(light, floorPoint(box, {4, 8 - 1e-6, 0})), 200 / (5 * 0.5 + 1), 1e-5);
  EXPECT_NEAR(whiteLevel(light, eastWallPoint(test, box, {8, 4, 3})), 200 / (4 * 0.5 + 1), 1e-12);
}

TEST(TruthLight, IsTheSameOnASphereAroundTheLight) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {8, 8}, {0, 8});
  test.addLight(box, {4, 4, 4}, 255, 1);
  const TruthLight light(test.finished());
  // 5 m away: circles of radius 3 around the middle of floor, ceiling and wall.
  for (double angle = 0; angle < 6.28; angle += 0.01) {
    const double c = 3 * std::cos(angle);
    const double s = 3 * std::sin(angle);
    ASSERT_NEAR(whiteLevel(light, floorPoint(box, {4 + c, 4 + s, 0})), 255 / 6.0, 1e-12);
    ASSERT_NEAR(whiteLevel(light, ceilingPoint(box, {4 + c, 4 + s, 8})), 255 / 6.0, 1e-12);
    ASSERT_NEAR(whiteLevel(light, eastWallPoint(test, box, {8, 4 + c, 4 + s})), 255 / 6.0, 1e-12);
  }
}

TEST(TruthLight, UnshadedPassesWalls) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {8, 8}, {0, 4});
  test.addLight(box, {4, 4, 3}, 200, 0.5);
  const TruthLight light(test.finished());
  const SurfacePoint beyondWall = floorPoint(box, {4, 8 + 1e-6, 0});
  EXPECT_EQ(light.from(0, beyondWall), 0);
  EXPECT_NEAR(light.unshaded(0, beyondWall), 200 / (5 * 0.5 + 1), 1e-5);
}

TEST(TruthLight, LambertMultipliesByTheCosine) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {8, 8}, {0, 4});
  test.addLight(box, {4, 4, 3}, 100);
  Level level = test.finished();
  level.bake.lambert = true;
  EXPECT_NEAR(whiteLevel(TruthLight(level), floorPoint(box, {4, 7.999, 0})),
              100 * 3 / std::hypot(3, 3.999), 1e-12);
}

TEST(TruthLight, MultipliesByColour) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {4, 4}, {0, 4});
  test.addLight(box, {1, 1, 1}, 255);
  test.addLight(box, {2, 2, 1}, 100);
  Level level = test.finished();
  std::ranges::copy(std::array<std::uint8_t, 3>{255, 51, 0}, level.lights[0].color);
  const Vec3 levels = TruthLight(level).at(floorPoint(box, {3, 3, 0}));
  EXPECT_NEAR(levels.x, 355, 1e-12);
  EXPECT_NEAR(levels.y, 151, 1e-12);
  EXPECT_NEAR(levels.z, 100, 1e-12);
}

TEST(TruthLight, SumsLightsWithoutClampingOrRounding) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {4, 4}, {0, 4});
  test.addLight(box, {1, 1, 1}, 200.25);
  test.addLight(box, {2, 2, 1}, 100.5);
  EXPECT_DOUBLE_EQ(whiteLevel(TruthLight(test.finished()), floorPoint(box, {3, 3, 0})), 300.75);
}

TEST(TruthLight, DoesNotLightTheSurfaceInWhosePlaneItLies) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {4, 4}, {0, 4});
  test.addLight(box, {4, 2, 0}, 100);  // where the floor meets the east wall
  const TruthLight light(test.finished());
  EXPECT_EQ(whiteLevel(light, floorPoint(box, {3, 3, 0})), 0);
  EXPECT_EQ(whiteLevel(light, eastWallPoint(test, box, {4, 3, 1})), 0);
  EXPECT_EQ(whiteLevel(light, ceilingPoint(box, {3, 3, 4})), 100);
}

TEST(TruthLight, InAPlaneMeansWithinAMicrometre) {
  TestLevel test;
  const SectorId box = test.addBox("box", {0, 0}, {4, 4}, {0, 4});
  test.addLight(box, {2, 2, 0.9e-6}, 1);
  test.addLight(box, {2, 2, 1.1e-6}, 2);
  EXPECT_EQ(whiteLevel(TruthLight(test.finished()), floorPoint(box, {3, 3, 0})), 2);
}

TEST(TruthLight, AStepThrowsItsShadowWhereTheGeometrySays) {
  TestLevel test;
  const SectorId west = test.addBox("west", {0, 0}, {4, 4}, {0, 4});
  const SectorId sill = test.addBox("sill", {4, 0}, {5, 4}, {1, 4});
  const SectorId east = test.addBox("east", {5, 0}, {12, 4}, {0, 4});
  test.link(west, sill);
  test.link(sill, east);
  test.addLight(west, {1, 2, 3}, 100);
  const TruthLight light(test.finished());
  // Over the sill's far edge (5, 1) light falls 2 m in 4 m: the floor is lit from x = 7 on.
  EXPECT_EQ(whiteLevel(light, floorPoint(east, {7 - 1e-9, 2, 0})), 0);
  EXPECT_EQ(whiteLevel(light, floorPoint(east, {7 + 1e-9, 2, 0})), 100);
  EXPECT_EQ(whiteLevel(light, floorPoint(sill, {4.5, 2, 1})), 100);
  EXPECT_EQ(whiteLevel(light, eastWallPoint(test, west, {4, 2, 0.5}, SurfaceKind::LowerStep)), 100);
}

TEST(TruthLight, DoesNotReachWhatMerelyOverlapsInSpace) {
  TestLevel test;
  const SectorId a = test.addBox("a", {0, 0}, {4, 4}, {0, 4});
  const SectorId b = test.addBox("b", {0, 0}, {4, 4}, {0, 4});
  test.addLight(a, {2, 2, 2}, 100);
  const TruthLight light(test.finished());
  EXPECT_EQ(whiteLevel(light, floorPoint(a, {1, 1, 0})), 100);
  EXPECT_EQ(whiteLevel(light, floorPoint(b, {1, 1, 0})), 0);
}

TEST(TruthLight, LeavesASealedRoomDarkThroughAllJointsOfItsWalls) {
  TestLevel test;
  const SectorId bright = test.addBox("bright", {0, 0}, {4, 4}, {0, 4});
  const SectorId dark = test.addBox("dark", {4, 0}, {8, 4}, {0, 4});
  test.addLight(bright, {3, 1, 3}, 1000);
  const TruthLight light(test.finished());
  for (double x = 4; x <= 8; x += 0.25)
    for (double y = 0; y <= 4; y += 0.25)
      ASSERT_EQ(whiteLevel(light, floorPoint(dark, {x, y, 0})), 0);
}

/// A yard under a sky at 3 m, and east of it a place whose ceiling is at 5 m.
struct Yard {
  TestLevel test;
  SectorId yard = test.addBox("yard", {0, 0}, {4, 4}, {0, 3});
  SectorId east = test.addBox("east", {4, 0}, {8, 4}, {0, 5});

  explicit Yard(bool isEastOpen) {
    test.link(yard, east);
    test.sector(yard).ceiling.isSky = true;
    test.sector(east).ceiling.isSky = isEastOpen;
  }
};

TEST(TruthLight, PassesSkyFromAboveAndBetweenSkies) {
  Yard scene(true);
  scene.test.addLight(scene.yard, {2, 2, 10}, 100);
  const TruthLight light(scene.test.finished());
  EXPECT_EQ(whiteLevel(light, floorPoint(scene.yard, {1, 1, 0})), 100);
  // Into the east at z = 5, over both skies.
  EXPECT_EQ(whiteLevel(light, floorPoint(scene.east, {6, 2, 0})), 100);
  EXPECT_EQ(whiteLevel(light, eastWallPoint(scene.test, scene.east, {8, 2, 4})), 100);
}

TEST(TruthLight, RisesThroughTheSkyIntoAHigherOne) {
  Yard scene(true);
  scene.test.addLight(scene.yard, {1, 2, 2.9}, 100);
  const TruthLight light(scene.test.finished());
  EXPECT_EQ(whiteLevel(light, eastWallPoint(scene.test, scene.east, {8, 2, 4.5})), 100);
}

TEST(TruthLight, PassesSkyFloorsFromBelow) {
  TestLevel test;
  const SectorId west = test.addBox("west", {0, 0}, {4, 4}, {2, 5});
  const SectorId east = test.addBox("east", {4, 0}, {8, 4}, {1, 5});
  const SectorId room = test.addBox("room", {-4, 0}, {0, 4}, {1, 5});
  for (const SectorId id : {west, east}) test.sector(id).floor.isSky = true;
  test.link(west, east);
  test.link(west, room);
  test.addLight(west, {2, 2, -10}, 100);
  const TruthLight light(test.finished());
  EXPECT_EQ(whiteLevel(light, ceilingPoint(west, {1, 1, 5})), 100);
  EXPECT_EQ(whiteLevel(light, eastWallPoint(test, east, {8, 2, 4})), 100);
  // Into the room only over west's own floor: through (0, 2) it rises 6 m per m.
  EXPECT_EQ(whiteLevel(light, ceilingPoint(room, {-0.5 + 1e-9, 2, 5})), 100);
  EXPECT_EQ(whiteLevel(light, ceilingPoint(room, {-0.5 - 1e-9, 2, 5})), 0);
}

TEST(TruthLight, PassesBelowSkyFloorsOnlyUpToTheLowerCeiling) {
  for (const double z : {1.9, 2.1}) {
    TestLevel test;
    const SectorId high = test.addBox("high", {0, 0}, {4, 4}, {3, 5});
    const SectorId low = test.addBox("low", {4, 0}, {8, 4}, {0, 2});
    for (const SectorId id : {high, low}) test.sector(id).floor.isSky = true;
    test.link(high, low);
    test.addLight(high, {3.9, 2, z}, 100);
    const TruthLight light(test.finished());
    EXPECT_EQ(whiteLevel(light, eastWallPoint(test, low, {8, 2, z - 0.5})), z < 2 ? 100 : 0) << z;
  }
}

TEST(TruthLight, IsStoppedBesideASkyWhereNothingShowsAndNothingIsTextured) {
  TestLevel test;
  const SectorId yard = test.addBox("yard", {0, 0}, {4, 4}, {0, 3});
  const SectorId room = test.addBox("room", {4, 0}, {8, 4}, {0, 3});
  test.link(yard, room);
  test.sector(yard).ceiling.isSky = true;
  std::get<Portal>(test.wall(yard, 1).wall).upper.reset();
  test.addLight(yard, {2, 2, 10}, 100);
  EXPECT_EQ(whiteLevel(TruthLight(test.finished()), floorPoint(room, {6, 2, 0})), 0);
}

TEST(TruthLight, PassesOnlyTheSharedOpeningIntoARoomWithoutSky) {
  Yard scene(false);
  scene.test.addLight(scene.yard, {2, 2, 10}, 100);
  const TruthLight light(scene.test.finished());
  // From (2, 10) through (4, 3), the top of the opening: 3.5 m down per m, so lit up to 6/7 m east.
  EXPECT_EQ(whiteLevel(light, floorPoint(scene.east, {4 + 6.0 / 7 - 1e-9, 2, 0})), 100);
  EXPECT_EQ(whiteLevel(light, floorPoint(scene.east, {4 + 6.0 / 7 + 1e-9, 2, 0})), 0);
}

TEST(TruthLight, SidesOfASkySectorAreSolidWithoutEndAboveItsSky) {
  TestLevel test;
  const SectorId yard = test.addBox("yard", {0, 0}, {4, 4}, {0, 3});
  const SectorId next = test.addBox("next", {4, 0}, {8, 4}, {0, 3});
  for (const SectorId id : {yard, next}) test.sector(id).ceiling.isSky = true;
  test.addLight(yard, {2, 2, 1000}, 100);
  const TruthLight light(test.finished());
  EXPECT_EQ(whiteLevel(light, floorPoint(yard, {1, 1, 0})), 100);
  EXPECT_EQ(whiteLevel(light, floorPoint(next, {4.001, 2, 0})), 0);
}

TEST(TruthLight, InAStackOnlyThePieceThatReachesTheSkyIsOpenAboveIt) {
  Yard scene(true);
  const TextureMapping texture = scene.test.texture();
  Stack stack;
  stack.subWalls = {{1, Portal{scene.east, texture, texture}}, {3, Solid{texture}}};
  scene.test.wall(scene.yard, 1).wall = stack;
  scene.test.addLight(scene.yard, {2, 2, 10}, 100);
  scene.test.addLight(scene.yard, {2, 2, 0.5}, 7);
  const TruthLight light(scene.test.finished());
  EXPECT_EQ(whiteLevel(light, floorPoint(scene.east, {6, 2, 0})), 7);
}

TEST(TruthLight, ShinesThroughFlatPortals) {
  TestLevel test;
  const SectorId above = test.addBox("above", {0, 0}, {4, 4}, {2, 4});
  const SectorId left = test.addBox("left", {0, 0}, {1, 4}, {0, 2});
  const SectorId right = test.addBox("right", {1, 0}, {4, 4}, {0, 2});
  test.connect({above}, {left, right});
  test.addLight(above, {0.5, 2, 3}, 100);
  const TruthLight light(test.finished());
  EXPECT_EQ(whiteLevel(light, floorPoint(left, {0.25, 2, 0})), 100);
  EXPECT_EQ(whiteLevel(light, floorPoint(right, {3, 2, 0})), 100);
  // Behind the wall between left and right: over its top edge (1, 2), 0.5 m in 1 m.
  EXPECT_EQ(whiteLevel(light, floorPoint(right, {2 - 1e-9, 2, 0})), 0);
  EXPECT_EQ(whiteLevel(light, floorPoint(right, {2 + 1e-9, 2, 0})), 100);
}

TEST(TruthLight, ALightAtTheEyeLightsAllThatTheEyeSees) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  int seen = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    TestScene scene = gridScene(seed);
    const SectorId sector{random() % 36};
    const Sector& outline = scene.level.finished()[sector];
    const Vec2 middle = 0.5 * (outline.box.min + outline.box.max);
    const double bottom = outline.authoredBottom(middle);
    const double top = outline.authoredTop(middle);
    if (top - bottom < 0.1) continue;
    const Vec3 eye{middle.x, middle.y, std::lerp(bottom, top, 0.4)};
    scene.level.addLight(sector, eye, 1);
    const Level& level = scene.level.level();
    const TruthLight light(level);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 direction{unit(random), unit(random), unit(random)};
      const auto hit = trace(level, sector, eye, direction, RayKind::Look);
      if (isSky(hit->kind)) continue;
      ASSERT_EQ(whiteLevel(light, *hit), 1) << name(hit->kind);
      ++seen;
    }
  }
  EXPECT_GT(seen, 10'000);
}

}  // namespace
}  // namespace hearth
