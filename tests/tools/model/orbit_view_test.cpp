// Cameras round a model.

#include "model/orbit_view.h"

#include <gtest/gtest.h>

#include "math/trig.h"
#include "model/model_air.h"
#include "render/camera.h"

namespace hearth {
namespace {

void expectNear(Vec3 a, Vec3 b, double most = 1e-12) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
  EXPECT_NEAR(a.z, b.z, most);
}

TEST(OrbitView, hasItsTargetInTheMiddleOfThePicture) {
  const OrbitView view{{1, 2, 3}, 4, 30, -40};
  const Camera camera{SectorId(0), view.eye(), view.angle, view.pitch, 70, 640, 400, 0};
  const Projection projection(camera, camera.eye);
  const CameraPoint target = projection.toCamera(view.target.xy());
  EXPECT_NEAR(target.depth, 4, 1e-12);
  EXPECT_NEAR(projection.columnOf(target), 320, 1e-9);
  EXPECT_NEAR(projection.rowOf(view.target.z, target.depth), 200, 1e-9);
}

/// A square of 2 m that faces +y, at y = 1.
const MeshFace kHalf{{Vec3{-1, 1, 0}, {1, 1, 0}, {1, 1, 2}}, {}, TextureId(0)};
const MeshFace kOtherHalf{{Vec3{-1, 1, 0}, {1, 1, 2}, {-1, 1, 2}}, {}, TextureId(0)};

TEST(FrontView, looksAtTheMiddleFromTheSideOfPlusYAndFromAbove) {
  const MeshFace square[] = {kHalf, kOtherHalf};
  const OrbitView view = frontView(square, 40, {300, 300});
  expectNear(view.target, {0, 1, 1});
  EXPECT_EQ(view.angle, 270);
  EXPECT_EQ(view.pitch, -20);
  EXPECT_GT(view.eye().y, 1);
  EXPECT_GT(view.eye().z, 1);
}

TEST(FrontView, leavesATwentiethOfThePictureOnEachSide) {
  const MeshFace square[] = {kHalf, kOtherHalf};
  // 2 m take nine tenths of the width: in a picture of 400 pixels, 360.
  const OrbitView view = frontView(square, 40, {400, 400});
  EXPECT_NEAR(view.distance, 1 / (0.9 * tanDegrees(20)), 1e-12);
  const Camera camera{SectorId(0), view.eye(), 270, -20, 40, 400, 400, 0};
  const Projection projection(camera, camera.eye);
  EXPECT_NEAR(projection.columnOf(projection.toCamera({-1, 1})), 20, 1e-9);
  EXPECT_NEAR(projection.columnOf(projection.toCamera({1, 1})), 380, 1e-9);
}

TEST(FrontView, isNoFartherAwayThanTheAirReaches) {
  const MeshFace square[] = {kHalf, kOtherHalf};
  const Box3 box = boxOf(square);
  EXPECT_EQ(frontView(square, 1, {300, 300}).distance, kFarthestRadii * radiusOf(box));
}

TEST(ViewFrom, keepsWhatACameraSees) {
  const Box3 box{{-1, -1, 0}, {1, 1, 2}};
  for (const Vec3 eye : {Vec3{5, 3, 2}, {-7, 0.3, -1}, {0.2, 0.1, 1}})
    for (const double angle : {0.0, 100.0, 190.0, 300.0}) {
      const Camera camera{SectorId(0), eye, angle, -17};
      const OrbitView view = viewFrom(camera, box);
      expectNear(view.eye(), eye);
      EXPECT_EQ(view.angle, angle);
      EXPECT_EQ(view.pitch, -17);
      EXPECT_GT(view.distance, 0);
    }
}

TEST(ViewFrom, goesRoundTheMiddleOfAModelThatItLooksAt) {
  const MeshFace square[] = {kHalf, kOtherHalf};
  const OrbitView front = frontView(square, 40, {320, 200});
  const Camera camera{SectorId(0), front.eye(), front.angle, front.pitch, 40, 320, 200, 0};
  const OrbitView view = viewFrom(camera, boxOf(square));
  expectNear(view.target, front.target);
  EXPECT_NEAR(view.distance, front.distance, 1e-12);
}

TEST(AirRound, holdsEveryEyeThatGoesRoundTheModelAndItsOrigin) {
  for (const Vec3 at : {Vec3{}, {1e6, -3e5, 7}, {0.25, 0, -9}}) {
    const Box3 box{at, at + Vec3{2, 0.5, 1}};
    const Box3 air = airRound(box);
    Box3 all = air;
    all.add(Vec3{});
    for (const double pitch : {-60.0, 0.0, 60.0})
      for (double angle = 0; angle < 360; angle += 45)
        all.add(OrbitView{centreOf(box), kFarthestRadii * radiusOf(box), angle, pitch}.eye());
    EXPECT_EQ(all, air);
  }
}

}  // namespace
}  // namespace hearth
