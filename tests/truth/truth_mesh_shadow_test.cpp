#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "lit_hall.h"
#include "mesh_shapes.h"
#include "truth/truth_light.h"
#include "truth/truth_view.h"

namespace hearth {
namespace {

/// Metres beside an edge of a shadow.
constexpr double kHair = 1e-9;

TEST(TruthMeshShadow, OfACubeUnderALightIsItsProjectionOnTheFloor) {
  LitHall scene;
  scene.addCube({3.5, 3.5});
  scene.light({4, 4, 3});
  const TruthLight light(scene.test.finished());
  // The top's edges, 0.5 m aside and 2 m below the light, fall on the floor 0.75 m aside.
  const auto isLit = [&](double right, double down) {
    return light.at(floorPoint(scene.hall, {4 + right, 4 + down})).x == 100;
  };
  for (const double along : {-0.7, -0.3, 0.0, 0.4, 0.7}) {
    for (const double side : {-1.0, 1.0}) {
      EXPECT_FALSE(isLit(side * (0.75 - kHair), along)) << along;
      EXPECT_FALSE(isLit(along, side * (0.75 - kHair))) << along;
      EXPECT_TRUE(isLit(side * (0.75 + kHair), along)) << along;
      EXPECT_TRUE(isLit(along, side * (0.75 + kHair))) << along;
    }
  }
  EXPECT_TRUE(isLit(0.75 + kHair, 0.75 + kHair));
  EXPECT_FALSE(isLit(0.75 - kHair, 0.75 - kHair));
  for (double right = -3.9; right < 4; right += 0.17)
    for (double down = -3.9; down < 4; down += 0.17)
      ASSERT_EQ(isLit(right, down), std::max(std::abs(right), std::abs(down)) > 0.75);
}

TEST(TruthMeshShadow, BeginsAtACubesFootOnTheSideAwayFromTheLight) {
  LitHall scene;
  scene.addCube({4, 3.5});
  scene.light({3, 4, 3});
  const TruthLight light(scene.test.finished());
  const auto at = [&](double x) { return light.at(floorPoint(scene.hall, {x, 4})).x; };
  EXPECT_EQ(at(4 - 1e-6), 100) << "before the cube";
  EXPECT_EQ(at(5 + kHair), 0) << "at its foot";
  // Over its top's far edge, 2 m aside and 2 m below the light, 3 m down: up to x = 6.
  EXPECT_EQ(at(6 - kHair), 0);
  EXPECT_EQ(at(6 + kHair), 100);
}

TEST(TruthMeshShadow, FallsOnWallsCeilingsAndSlopesToo) {
  LitHall scene;
  scene.add(boxOf({5, 3.5, 1.5}, {6, 4.5, 2.5}, scene.image));
  scene.light({4, 4, 2});
  scene.light({5.5, 4, 1}, 10);
  Slope& slope = scene.test.sector(scene.hall).floorSlope.emplace();
  slope.zAt0 = 0.25;
  slope.gradient = {0, 0.05};
  const Level& level = scene.test.finished();
  // 4 m away, behind a front 1 m away whose edges are 0.5 m aside.
  const auto onWall = [&](double y) {
    return SurfacePoint{
        SurfaceKind::Solid, scene.hall, scene.test.wallId(scene.hall, 1), {8, y, 2}, {-1, 0, 0}};
  };
  EXPECT_EQ(levelAt(level, onWall(4)), 10);
  EXPECT_EQ(levelAt(level, onWall(5.9)), 10);
  EXPECT_EQ(levelAt(level, onWall(6.1)), 110);
  // 3 m above the second light, behind a bottom 0.5 m above it: 0.5 m aside becomes 3 m.
  const auto onCeiling = [&](double y) {
    return SurfacePoint{SurfaceKind::Ceiling, scene.hall, std::nullopt, {5.5, y, 4}, {0, 0, -1}};
  };
  EXPECT_EQ(levelAt(level, onCeiling(6.9)), 100);
  EXPECT_EQ(levelAt(level, onCeiling(7.1)), 110);
  const Vec3 up = (1 / std::hypot(1, 0.05)) * Vec3{0, -0.05, 1};
  const auto onSlope = [&](double x) {
    const SurfacePoint place{SurfaceKind::SlopeFloor, scene.hall, std::nullopt, {x, 4, 0.45}, up};
    return levelAt(level, place);
  };
  EXPECT_EQ(onSlope(4), 110);
  EXPECT_EQ(onSlope(7.9), 10) << "the box stands before the first light, not before the second";
}

TEST(TruthMeshShadow, IsCastByFrontsAndBacks) {
  for (const bool isFromAbove : {false, true}) {
    LitHall scene;
    const std::vector<MeshFace> table = tableAt(1, {3, 3}, {5, 5}, scene.image);
    scene.add(isFromAbove ? table : turnedOver(table));
    scene.light({4, 4, 3});
    EXPECT_EQ(levelAt(scene.test.finished(), floorPoint(scene.hall, {4.2, 4.3})), 0);
  }
}

TEST(TruthMeshShadow, IsNoneOfAMeshThatCastsNone) {
  LitHall scene;
  scene.addCube({3.5, 3.5}).castsShadow = false;
  scene.light({4, 4, 3});
  const Level& level = scene.test.finished();
  EXPECT_EQ(levelAt(level, floorPoint(scene.hall, {4, 4})), 100);
  EXPECT_EQ(levelAt(level, facePoint(level, 0, kBoxTop, {4, 4.2, 1})), 100) << "its top is lit";
  EXPECT_EQ(levelAt(level, facePoint(level, 0, kBoxBottom, {4, 4.2, 0})), 0)
      << "its bottom faces away";
}

TEST(TruthMeshShadow, OfOthersFallsOnAMeshThatCastsNone) {
  LitHall scene;
  scene.add(tableAt(1, {3, 3}, {5, 5}, scene.image)).castsShadow = false;
  scene.add(tableAt(2, {4, 3}, {6, 5}, scene.image));
  scene.light({4, 4, 3});
  const Level& level = scene.test.finished();
  const auto at = [&](double x) { return levelAt(level, facePoint(level, 0, 0, {x, 3.5, 1})); };
  EXPECT_EQ(at(4 - kHair), 100);
  EXPECT_EQ(at(4 + kHair), 0);
}

TEST(TruthMeshShadow, IsNoneOfWhatLiesWithinAHairOfTheLitPoint) {
  for (const double height : {0.9e-7, 1.1e-7}) {
    LitHall scene;
    scene.add(tableAt(height, {3, 3}, {5, 5}, scene.image));
    scene.light({4, 4, 3});
    EXPECT_EQ(levelAt(scene.test.finished(), floorPoint(scene.hall, {4, 4})),
              height < 1e-7 ? 100 : 0);
  }
}

TEST(TruthMeshShadow, LeavesNoGapBetweenFaces) {
  LitHall scene;
  // A roof of four faces around (4, 4, 2), and the light above its top.
  const std::array<Vec3, 4> rim{Vec3{3, 3, 1.5}, {5, 3, 1.25}, {5, 5, 1.5}, {3, 5, 1.125}};
  std::vector<MeshFace> roof;
  for (std::size_t i = 0; i < 4; ++i)
    roof.push_back({{Vec3{4, 4, 2}, rim[(i + 1) % 4], rim[i]}, {}, scene.image});
  scene.add(roof);
  scene.light({4, 4, 3});
  const TruthLight light(scene.test.finished());
  for (int i = -16; i <= 16; ++i)
    for (const double across : {-1.0, 0.0, 1.0}) {
      const Vec2 p{4 + i / 16.0, 4 + across * i / 16.0};
      ASSERT_EQ(light.at(floorPoint(scene.hall, p)).x, 0) << p.x << ' ' << p.y;
    }
}

TEST(TruthMeshShadow, FallsOnPointsOfAir) {
  LitHall scene;
  scene.addCube({4, 3.5});
  scene.light({3, 4, 3});
  const Level& level = scene.test.finished();
  const TruthLight light(level);
  const auto at = [&](double x, double z) { return light.at(AirPoint{{x, 4, z}, scene.hall}).x; };
  EXPECT_EQ(at(5.5, 0.5 - kHair), 0);
  EXPECT_EQ(at(5.5, 0.5 + kHair), 100);
  EXPECT_EQ(at(4.5, 0.5), 0) << "in the cube";
}

TEST(TruthMeshShadow, FallsOnSprites) {
  for (const bool castsShadow : {false, true}) {
    LitHall scene;
    scene.add(tableAt(2, {4, 3}, {8, 5}, scene.image)).castsShadow = castsShadow;
    scene.light({6, 4, 3});
    const TextureMapping onSprite = scene.test.texture();
    scene.test.addSprite(scene.hall, {6, 4, 0}, Facing::Camera, {1, 1}, onSprite);
    scene.test.finished();
    const TruthView view(scene.test.level(), scene.test.textures(),
                         cameraAt(scene.hall, {1, 4, 0.5}));
    const TruthPixel pixel = view.pixel(4, 2, TruthLightMode::Only);
    EXPECT_EQ(pixel.hit.kind, SurfaceKind::CameraSprite);
    EXPECT_NEAR(pixel.exact.x, castsShadow ? 0 : 100, 1e-9);
  }
}

TEST(TruthMeshShadow, OfAPanelLeavesHalfOfABallSeen) {
  LitHall scene;
  scene.add(tableAt(1.5, {4, 0}, {8, 8}, scene.image));
  scene.light({4, 4, 3}).radius = 0.5;
  const TruthLight light(scene.test.finished());
  const auto seen = [&](double x) { return light.seenFraction(0, floorPoint(scene.hall, {x, 4})); };
  EXPECT_NEAR(seen(4), 0.5, 0.004);
  EXPECT_EQ(seen(3.4), 1);
  EXPECT_EQ(seen(4.6), 0);
  // The plane through the point and the panel's edge, 1.5 m above the floor, leaves the centre on
  // the side that is seen, at a distance of h radii: all but a cap of the ball is seen.
  const double h = 1.5 * 0.1 / std::hypot(0.1, 1.5) / 0.5;
  EXPECT_NEAR(seen(3.9), 0.5 + (3 * h - h * h * h) / 4, 0.004);
  EXPECT_NEAR(seen(4.1), 0.5 - (3 * h - h * h * h) / 4, 0.004);
}

TEST(TruthMeshShadow, TakesNoPartOfABallThatAMeshReachesInto) {
  for (const bool castsShadow : {false, true}) {
    LitHall scene;
    scene.add(boardAcrossX(4.25, {3, 2}, {5, 4}, scene.image)).castsShadow = castsShadow;
    scene.light({4, 4, 3}).radius = 0.5;
    const TruthLight light(scene.test.finished());
    // Behind the panel, half a radius from the centre, is a cap of (2 - 3 / 2 + 1 / 8) / 4. It
    // shines to its side.
    EXPECT_NEAR(light.seenFraction(0, floorPoint(scene.hall, {1, 4})),
                castsShadow ? 1 - 0.625 / 4 : 1, 0.004);
    EXPECT_NEAR(light.seenFraction(0, floorPoint(scene.hall, {7, 4})), castsShadow ? 0.625 / 4 : 1,
                0.004);
  }
}

}  // namespace
}  // namespace hearth
