// Where cameras look and points show: numbers that hold for every renderer in perspective. See
// mesh_vectors.h.

#include <gtest/gtest.h>

#include <cmath>

#include "load/link/place_model.h"
#include "math/trig.h"
#include "mesh_vectors.h"

namespace hearth {
namespace {

using test::frustum;
using test::horizontalFov;
using test::kPrinted;
using test::kPrintedPixels;
using test::kRadians;
using test::pixelOf;
using test::seen;

// --- Perspective ---------------------------------------------------------------------------------

TEST(ViewVectors, aVerticalFieldOfViewIsThisHorizontalOne) {
  EXPECT_NEAR(horizontalFov(60, 1280, 720), 91.49284, 1e-5);
  EXPECT_NEAR(horizontalFov(60, 960, 640), 81.78679, 1e-5);
  EXPECT_NEAR(horizontalFov(60, 965, 655), 80.76898, 1e-5);
}

TEST(ViewVectors, aPictureScalesBySideAndHeightAsTheFrustumDoes) {
  struct Scales {
    int width, height;
    double side, up;  // of half the picture, per metre to the side and up at a depth of 1 m
  };
  for (const auto& [width, height, side, up] :
       {Scales{1280, 720, 0.974279, 1.732051}, Scales{640, 480, 1.299038, 1.732051},
        Scales{960, 640, 1.154701, 1.732051}, Scales{965, 655, 1.175641, 1.732051}}) {
    const Projection projection = frustum(width, height);
    EXPECT_NEAR(projection.distancePx() / (width / 2.0), side, kPrinted);
    EXPECT_NEAR(projection.distancePx() / (height / 2.0), up, kPrinted);
  }
}

TEST(ViewVectors, pointsShowInThesePixels) {
  struct Point {
    int width, height;
    Vec3 at;
    Vec2 pixel;
  };
  for (const auto& [width, height, at, pixel] :
       {Point{1280, 720, seen(1, 1, 5), {764.7077, 235.2923}},
        Point{1280, 720, seen(-1, 2, 4), {484.1154, 48.2309}},
        Point{965, 655, seen(1, 1, 5), {595.9493, 214.0507}}}) {
    const Vec2 shown = pixelOf(frustum(width, height), at);
    EXPECT_NEAR(shown.x, pixel.x, kPrintedPixels);
    EXPECT_NEAR(shown.y, pixel.y, kPrintedPixels);
  }
}

TEST(ViewVectors, thePicturesBordersAreTheFrustumsPlanes) {
  const Projection projection = frustum(965, 655);
  // Normals of the planes, inwards: up and ahead, right and ahead.
  EXPECT_NEAR(-0.866025 * projection.raySlopeAt(0) + 0.5, 0, kPrinted);
  EXPECT_NEAR(0.866025 * projection.raySlopeAt(655) + 0.5, 0, kPrinted);
  EXPECT_NEAR(0.761714 * projection.slantOf(0) + 0.647914, 0, kPrinted);
  EXPECT_NEAR(-0.761714 * projection.slantOf(965) + 0.647914, 0, kPrinted);
}

// --- Looks ---------------------------------------------------------------------------------------

struct Look {
  Vec3 eye, target;  ///< right, up, ahead
  Vec2 right;        ///< of the camera, in the world: right, ahead
  double origin;     ///< of the world, to the camera's right
};

TEST(ViewVectors, camerasThatLookAtAPointHaveItInTheirMiddle) {
  for (const auto& [eye, target, right, origin] :
       {Look{seen(0, 0, -5), {}, {1, 0}, 0}, Look{seen(5, 0, 0), {}, {0, 1}, 0},
        Look{seen(1, 1, -1), seen(0, 0, 4), {0.980581, 0.196116}, -0.784465}}) {
    const Vec3 look = target - eye;
    const double pitch = std::atan(look.z / length(look.xy())) / kRadians;
    const Projection projection(
        {SectorId(0), eye, compassDegrees(look.xy()), pitch, 90, 640, 480, 0}, eye);
    const Vec2 toRight = turned90(projection.direction());
    EXPECT_NEAR(toRight.y, right.x, kPrinted);
    EXPECT_NEAR(toRight.x, right.y, kPrinted);
    EXPECT_NEAR(projection.toCamera({}).lateral, origin, kPrinted);
    const Vec2 middle = pixelOf(projection, target);
    EXPECT_NEAR(middle.x, 320, kPrintedPixels);
    EXPECT_NEAR(middle.y, 240, kPrintedPixels);
  }
}

TEST(ViewVectors, theOriginIsFiveMetresAheadOfCamerasThatLookAtItFromThere) {
  for (const Vec3 eye : {seen(0, 0, -5), seen(5, 0, 0)}) {
    const Projection projection({SectorId(0), eye, compassDegrees(Vec2{} - eye.xy())}, eye);
    EXPECT_DOUBLE_EQ(projection.toCamera({}).depth, 5);
  }
}

TEST(ViewVectors, turnsAndPitchesLookThere) {
  struct Direction {
    double angle, pitch;
    Vec3 look;
  };
  for (const auto& [angle, pitch, look] :
       {Direction{0, 0, seen(0, 0, 1)}, Direction{90, 0, seen(1, 0, 0)},
        Direction{0, -30, seen(0, -0.5, 0.866025)},
        Direction{45, -30, seen(0.612372, -0.5, 0.612372)}}) {
    const Projection projection({SectorId(0), {}, angle, pitch, 90, 640, 480, 0}, {});
    const Vec2 ahead = projection.rayOf(320);
    const Vec3 middle{ahead.x, ahead.y, projection.raySlopeAt(240)};
    const Vec3 unit = (1 / length(middle)) * middle;
    EXPECT_NEAR(unit.x, look.x, kPrinted);
    EXPECT_NEAR(unit.y, look.y, kPrinted);
    EXPECT_NEAR(unit.z, look.z, kPrinted);
  }
}

TEST(ViewVectors, aQuarterTurnOfAModelAboutTheUprightAxisIsThis) {
  // (right, up, ahead) = (1, 2, 3) becomes (3, 2, -1).
  const ModelFace model{{Vec3{3, 2, 1}, {0, 0, 0}, {1, 0, 0}}, {}, {}, 1};
  const MeshFace turned = ModelPlacement({1, 1, 1}, 90, {})(model);
  EXPECT_NEAR(turned.corners[0].x, seen(3, 2, -1).x, 1e-12);
  EXPECT_NEAR(turned.corners[0].y, seen(3, 2, -1).y, 1e-12);
  EXPECT_NEAR(turned.corners[0].z, seen(3, 2, -1).z, 1e-12);
}

}  // namespace
}  // namespace hearth
