#include "truth/thing_sectors.h"

#include <gtest/gtest.h>

#include "adjoining_rooms.h"
#include "test_level.h"
#include "truth/truth_view.h"

namespace hearth {
namespace {

/// An upright rectangle above a line of the map.
Polygon upright(Vec2 a, Vec2 b, double zBottom, double zTop) {
  return {{a.x, a.y, zBottom}, {b.x, b.y, zBottom}, {b.x, b.y, zTop}, {a.x, a.y, zTop}};
}

Polygon lying(Vec2 min, Vec2 max, double z) {
  return {{min.x, min.y, z}, {max.x, min.y, z}, {max.x, max.y, z}, {min.x, max.y, z}};
}

TEST(ThingSectors, AreItsOwnAndThoseBehindOpeningsThatItCrosses) {
  EXPECT_EQ(Row({{0, 4}, {0, 4}, {0, 4}}).names(upright({1, 2}, {3, 2}, 0, 1)), "a");
  EXPECT_EQ(Row({{0, 4}, {0, 4}, {0, 4}}).names(upright({3, 2}, {5, 2}, 0, 1)), "ab");
  EXPECT_EQ(Row({{0, 4}, {0, 4}, {0, 4}}).names(upright({3, 2}, {9, 3}, 0, 1)), "abc");
  EXPECT_EQ(Row({{0, 4}, {0, 4}, {0, 4}}).names(upright({3, 2}, {9, 3}, 0, 1), 2), "abc");
}

TEST(ThingSectors, CrossingIncludesTouching) {
  EXPECT_EQ(Row({{0, 4}, {0, 4}}).names(upright({4, 1}, {4, 2}, 0, 1)), "ab") << "in its plane";
  EXPECT_EQ(Row({{0, 4}, {0, 4}}).names(upright({3, 1}, {4, 2}, 0, 1)), "ab");
  EXPECT_EQ(Row({{0, 4}, {0, 4}}).names(upright({3, 1}, {3.9999, 2}, 0, 1)), "a");
  EXPECT_EQ(Row({{0, 4}, {0, 4}}).names(lying({3, 1}, {5, 2}, 0)), "ab") << "a rug on both floors";
  EXPECT_EQ(Row({{0, 4}, {-1, 4}}).names(lying({3, 1}, {5, 2}, 0)), "ab") << "over the edge";
}

TEST(ThingSectors, AreNotThoseBehindStepsAndSolidWalls) {
  EXPECT_EQ(Row({{0, 4}, {1, 4}}).names(upright({3, 2}, {5, 2}, 0, 0.9)), "a");
  EXPECT_EQ(Row({{0, 4}, {1, 4}}).names(upright({3, 2}, {5, 2}, 0, 1.1)), "ab");
  EXPECT_EQ(Row({{0, 4}, {0, 2}}).names(upright({3, 2}, {5, 2}, 2.1, 3)), "a");
  EXPECT_EQ(Row({{0, 4}, {2, 2}}).names(upright({3, 2}, {5, 2}, 0, 4)), "a") << "a closed door";
  Row walled({{0, 4}, {0, 4}});
  walled.test.wall(walled.rooms[0], 1).wall = Solid{walled.test.texture()};
  EXPECT_EQ(walled.names(upright({3, 2}, {5, 2}, 0, 1)), "a");
  EXPECT_EQ(namesOf(walled.test.level(), walled.rooms[1], {upright({3, 2}, {5, 2}, 0, 1)}), "ab")
      << "one-way";
}

TEST(ThingSectors, KnowTheHeightsOfSubWalls) {
  const auto names = [](double zBottom, double zTop) {
    Row row({{0, 4}, {0, 4}});
    row.leaveHatch();
    return row.names(upright({3, 2}, {5, 2}, zBottom, zTop));
  };
  EXPECT_EQ(names(0, 0.9), "a");
  EXPECT_EQ(names(0, 1.1), "ab");
  EXPECT_EQ(names(2.1, 3), "a");
  EXPECT_EQ(names(1.4, 1.6), "ab");
}

TEST(ThingSectors, KnowWhatSlopesLeaveOfAnOpening) {
  const auto names = [](double y, double zTop) {
    Row row({{0, 4}, {0, 4}});
    Slope slope;  // 1 m high at y = 0, and 3 m at y = 4
    slope.zAt0 = 1;
    slope.gradient = {0, 0.5};
    slope.sidewall = row.test.texture();
    row.test.sector(row.rooms[1]).floorSlope = slope;
    return row.names(upright({3, y}, {5, y}, 0, zTop));
  };
  EXPECT_EQ(names(1, 1.4), "a");
  EXPECT_EQ(names(1, 1.6), "ab");
  EXPECT_EQ(names(3, 1.6), "a");
  EXPECT_EQ(names(3, 2.6), "ab");
}

TEST(ThingSectors, AreThoseOfTheOtherSideOfAFlatPortalWhereItCrosses) {
  EXPECT_EQ(Storeys().names(SectorId(0), upright({1, 2}, {2, 2}, 1, 2.9)), "a");
  EXPECT_EQ(Storeys().names(SectorId(0), upright({1, 2}, {2, 2}, 1, 3.1)), "ac");
  EXPECT_EQ(Storeys().names(SectorId(0), upright({2, 2}, {3.5, 2}, 1, 3.1)), "acd");
  EXPECT_EQ(Storeys().names(SectorId(2), upright({1, 2}, {2, 2}, 2.9, 4)), "ac");
  EXPECT_EQ(Storeys().names(SectorId(1), upright({5, 2}, {6, 2}, 1, 3)), "bd") << "touches it";
  EXPECT_EQ(Storeys().names(SectorId(0), lying({1, 1}, {2, 2}, 3)), "ac") << "lies in it";
  EXPECT_EQ(Storeys().names(SectorId(0), lying({2, 1}, {3, 2}, 3)), "acd") << "and touches d";
  EXPECT_EQ(Storeys().names(SectorId(0), lying({-1, -1}, {9, 5}, 3)), "abcd") << "over all, by d";
  EXPECT_EQ(Storeys().names(SectorId(0), lying({1, 1}, {2, 2}, 2.9)), "a");
}

TEST(ThingSectors, AreNotThoseThatAFlatPortalHasBehindAWall) {
  TestLevel test;
  const SectorId a = test.addBox("a", {0, 0}, {4, 4}, {0, 3});
  const SectorId b = test.addBox("b", {4, 0}, {8, 4}, {0, 3});
  const SectorId c = test.addBox("c", {0, 0}, {4, 4}, {3, 6});
  const SectorId d = test.addBox("d", {4, 0}, {8, 4}, {3, 6});
  test.connect({c, d}, {a, b});
  EXPECT_EQ(namesOf(test.finished(), a, {upright({3, 2}, {5, 2}, 2, 4)}), "ac");
  EXPECT_EQ(namesOf(test.level(), a, {upright({3, 2}, {4, 2}, 2, 4)}), "ac") << "up to the wall";
}

// ---- of triangles

TEST(ThingSectors, OfATriangleAreThoseThatOneCornerReaches) {
  const Polygon pointed{{1, 1, 0}, {1, 3, 0}, {4, 2, 1}};
  EXPECT_EQ(Row({{0, 4}, {0, 4}}).names(pointed), "ab") << "touches";
  EXPECT_EQ(Row({{0, 4}, {0.9, 4}}).names(pointed), "ab");
  EXPECT_EQ(Row({{0, 4}, {1.1, 4}}).names(pointed), "a") << "ends before the step";
  const Polygon longer{{1, 1, 0}, {1, 3, 0}, {7, 2, 2}};
  EXPECT_EQ(Row({{0, 4}, {0.9, 4}}).names(longer), "ab") << "1 m high where it crosses";
  EXPECT_EQ(Row({{0, 4}, {1.1, 4}}).names(longer), "a");
  EXPECT_EQ(Row({{0, 4}, {0, 0.9}}).names(longer), "a");
}

TEST(ThingSectors, OfATriangleAreNotThoseThatItsBoxAloneReaches) {
  const Polygon half{{3, 1, 0}, {5, 1, 2}, {3, 1, 2}};  // across the opening it is over 1 m high
  EXPECT_EQ(Row({{0, 4}, {0, 1.1}}).names(half), "ab");
  EXPECT_EQ(Row({{0, 4}, {0, 0.9}}).names(half), "a");
  const Polygon beside{{3, 3, 1}, {5, 5, 1}, {3, 5, 1}};  // across the wall's line at y = 4
  EXPECT_EQ(Row({{0, 4}, {0, 4}}).names(beside), "ab") << "touches the opening's end";
  const Polygon pastTheEnd{{3, 3.1, 1}, {5, 5.1, 1}, {3, 5.1, 1}};
  EXPECT_EQ(Row({{0, 4}, {0, 4}}).names(pastTheEnd), "a");
}

TEST(ThingSectors, OfAThingAreThoseThatAnyOfItsPolygonsReachFromAnother) {
  const std::vector<TestLevel::Heights> heights{{0, 4}, {0, 4}, {0, 4}};
  const Polygon first{{3, 1, 1}, {5, 1, 1}, {4, 2, 1}};
  const Polygon second{{7, 1, 1}, {9, 1, 1}, {8, 2, 1}};
  Row row(heights);
  EXPECT_EQ(namesOf(row.test.finished(), row.rooms[0], {first, second}), "abc");
  EXPECT_EQ(namesOf(row.test.level(), row.rooms[0], {second}), "a") << "through no other";
  EXPECT_EQ(namesOf(row.test.level(), row.rooms[0], {}), "a");
}

TEST(ThingSectors, OfTrianglesKnowWhereTheyCrossAFlatPortal) {
  // It crosses the height of 3 m from x = 1 to x = 2, and reaches farther only above and below.
  const Polygon steep{{1, 2, 2}, {3, 2, 2}, {1, 2, 4}};
  EXPECT_EQ(Storeys().names(SectorId(0), steep), "ac");
  const Polygon farther{{1, 2, 2}, {3, 2, 2}, {5, 2, 5}};
  EXPECT_EQ(Storeys().names(SectorId(0), farther), "acd");
  const Polygon slanted{
      {1, 1, 2.5}, {1, 3, 2.5}, {6, 2, 3.1}};  // at 3 m where x > 5: past the wall
  EXPECT_EQ(Storeys().names(SectorId(0), slanted), "a");
  const Polygon tip{{1, 1, 1}, {2, 1, 1}, {1.5, 1, 3}};
  EXPECT_EQ(Storeys().names(SectorId(0), tip), "ac") << "touches it";
}

// ---- seen there

/// Whether the camera at the eye, which looks along `angle`, sees a sprite straight ahead.
bool seesSprite(const TestLevel& test, SectorId sector, Vec3 eye, double angle) {
  const Shot camera = cameraAt(sector, eye, angle);
  return isSprite(TruthView(test.level(), test.textures(), camera).hit(4, 2).kind);
}

/// Two rooms along x, in the first a sprite that reaches 1 m into where the second is, across y.
struct Straddled : Row {
  Straddled() : Row({{0, 4}, {0, 4}}) {
    Sprite& sprite = test.addSprite(rooms[0], {4, 2, 0}, Facing::Angle, {2, 2}, test.texture(4, 4));
    sprite.angle = 90;
  }
};

TEST(TruthSprites, ShowOnBothSidesOfAnOpeningThatTheyStraddle) {
  Straddled scene;
  scene.test.finished();
  for (const double x : {3.5, 4.5}) {
    EXPECT_TRUE(seesSprite(scene.test, scene.rooms[x > 4], {x, 0.5, 1}, 90));
    EXPECT_TRUE(seesSprite(scene.test, scene.rooms[x > 4], {x, 3.5, 1}, 270));
  }
}

TEST(TruthSprites, DoNotShowBehindASolidWallThatTheyPokeThrough) {
  Straddled scene;
  scene.close();
  scene.test.finished();
  EXPECT_TRUE(seesSprite(scene.test, scene.rooms[0], {3.5, 0.5, 1}, 90));
  EXPECT_FALSE(seesSprite(scene.test, scene.rooms[1], {4.5, 0.5, 1}, 90));
}

TEST(TruthSprites, ThatStandInAnOpeningShowFromBothSides) {
  Row row({{0, 4}, {0, 4}});
  row.test.addSprite(row.rooms[1], {4, 2, 0}, Facing::Angle, {2, 2}, row.test.texture(4, 4));
  row.test.finished();
  EXPECT_TRUE(seesSprite(row.test, row.rooms[0], {2, 2, 1}, 0));
  EXPECT_TRUE(seesSprite(row.test, row.rooms[1], {6, 2, 1}, 180));
}

TEST(TruthSprites, AreHiddenByStepsBeforeThemAndSeenThroughTheOpening) {
  Row row({{0, 4}, {1, 4}});
  row.test.addSprite(row.rooms[1], {6, 2, 1}, Facing::Camera, {2, 2}, row.test.texture(4, 4));
  const Level& level = row.test.finished();
  // Over the edge of the step, 3 m ahead and half a metre up, one sees what is above 1 1/3 m at 5
  // m.
  const TruthView view(level, row.test.textures(), cameraAt(row.rooms[0], {1, 2, 0.5}));
  EXPECT_EQ(view.hit(4, 2 - 4 * 0.8 / 5).kind, SurfaceKind::LowerStep);
  EXPECT_EQ(view.hit(4, 2 - 4 * 0.86 / 5).kind, SurfaceKind::CameraSprite);
}

TEST(TruthSprites, AreSeenThroughStacksAndFlatPortals) {
  Row row({{0, 4}, {0, 4}});
  row.leaveHatch();
  row.test.addSprite(row.rooms[1], {6, 2, 0}, Facing::Camera, {2, 4}, row.test.texture(4, 4));
  row.test.finished();
  EXPECT_TRUE(seesSprite(row.test, row.rooms[0], {2, 2, 1.5}, 0));
  EXPECT_FALSE(seesSprite(row.test, row.rooms[0], {2, 2, 0.5}, 0));
  EXPECT_FALSE(seesSprite(row.test, row.rooms[0], {2, 2, 2.5}, 0));

  Storeys storeys;
  storeys.test.addSprite(storeys.upper[1], {7, 2, 3}, Facing::Camera, {2, 3},
                         storeys.test.texture(4, 4));
  const TruthView view(storeys.test.finished(), storeys.test.textures(),
                       cameraAt(storeys.lower[1], {4.5, 2, 2.5}));
  const TruthHit hit = view.hit(4, 2 - 4 * 1 / 2.5);  // 3.5 m up, 2.5 m ahead
  EXPECT_EQ(hit.kind, SurfaceKind::CameraSprite);
  EXPECT_EQ(hit.sector, storeys.upper[1]);
  EXPECT_EQ(view.hit(4, 2 - 4 * 0.4 / 2.5).kind, SurfaceKind::Solid);
}

TEST(TruthSprites, InAnotherSectorAtThePlaceDoNotShow) {
  TestLevel test;
  const SectorId here = test.addBox("here", {0, 0}, {8, 4}, {0, 4});
  const SectorId there = test.addBox("there", {0, 0}, {8, 4}, {0, 4});
  test.addSprite(there, {5, 2, 0}, Facing::Camera, {2, 2}, test.texture(4, 4));
  test.finished();
  EXPECT_FALSE(seesSprite(test, here, {1, 2, 1}, 0));
  EXPECT_TRUE(seesSprite(test, there, {1, 2, 1}, 0));
}

TEST(TruthSprites, TakeTheLightOfTheirOwnSector) {
  Straddled scene;
  scene.test.sector(scene.rooms[0]).light = 0.2;
  scene.test.sector(scene.rooms[1]).light = 0.6;
  scene.test.finished();
  Shot camera = cameraAt(scene.rooms[1], {4.5, 0.5, 1});
  camera.angle = 90;
  const TruthView view(scene.test.level(), scene.test.textures(), camera);
  EXPECT_EQ(view.hit(4, 2).sector, scene.rooms[0]);
  EXPECT_NEAR(view.pixel(4, 2, TruthLightMode::Only).exact.x, 51, 1e-9);
}

TEST(TruthSprites, OnAnOpeningTakeTheLightOfBothItsSides) {
  Straddled scene;
  scene.test.addLight(scene.rooms[0], {2, 2, 1}, 50);
  scene.test.addLight(scene.rooms[1], {6, 2, 1}, 20);
  scene.test.finished();
  Shot camera = cameraAt(scene.rooms[1], {4.5, 0.5, 1});
  camera.angle = 90;
  const TruthView view(scene.test.level(), scene.test.textures(), camera);
  EXPECT_NEAR(view.pixel(4, 2, TruthLightMode::Only).exact.x, 70, 1e-9);
}

}  // namespace
}  // namespace hearth
