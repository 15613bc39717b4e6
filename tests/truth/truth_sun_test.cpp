// Suns and spots, as the file format defines them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lit_hall.h"
#include "test_level.h"
#include "truth/truth_light.h"

namespace hearth {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A white sun.
LightSource sunOf(Sun sun, double intensity = 255) {
  LightSource light;
  light.sun = sun;
  light.intensity = intensity;
  return light;
}

/// A yard of 40 x 40 m whose walls end in the sky at 3 m.
struct Yard {
  TestLevel test;
  SectorId yard = test.addBox("yard", {0, 0}, {40, 40}, {0, 3});
  Level level;

  explicit Yard(const LightSource& sun) {
    test.sector(yard).ceiling.isSky = true;
    level = test.finished();
    level.lights = {sun};
  }

  SurfacePoint wallPoint(std::size_t wall, Vec3 point, Vec3 normal) const {
    return {SurfaceKind::Solid, yard, test.wallId(yard, wall), point, normal};
  }
};

TEST(TruthSun, ShinesOnAllThatLooksIntoTheSkyTowardsIt) {
  // Its light comes from +x.
  LightSource sun = sunOf({0, 45, 0}, 200);
  sun.color[1] = 51;
  sun.color[2] = 0;
  const Yard yard(sun);
  const TruthLight light(yard.level);
  EXPECT_EQ(light.at(floorPoint(yard.yard, {20, 20})), (Vec3{200, 40, 0}));
  EXPECT_EQ(light.at(yard.wallPoint(3, {0, 20, 1}, {1, 0, 0})).x, 200);
  EXPECT_EQ(light.at(yard.wallPoint(1, {40, 20, 1}, {-1, 0, 0})).x, 0) << "it is behind that";
  EXPECT_EQ(light.at(yard.wallPoint(0, {20, 0, 1}, {0, 1, 0})).x, 0) << "it is in its plane";
}

TEST(TruthSun, MakesAShadowAsLongAsAWallIsHighOverTheTangent) {
  const Yard yard(sunOf({0, 30, 0}));
  const TruthLight light(yard.level);
  const double shadow = 3 / std::tan(30 * kDegree);
  EXPECT_EQ(light.at(floorPoint(yard.yard, {40 - shadow + 1e-6, 20})).x, 0);
  EXPECT_EQ(light.at(floorPoint(yard.yard, {40 - shadow - 1e-6, 20})).x, 255);
}

TEST(TruthSun, LambertMultipliesByTheCosine) {
  Yard yard(sunOf({0, 30, 0}, 100));
  yard.level.bake.lambert = true;
  const TruthLight light(yard.level);
  EXPECT_NEAR(light.at(floorPoint(yard.yard, {20, 20})).x, 50, 1e-12);
  EXPECT_NEAR(light.at(yard.wallPoint(3, {0, 20, 1}, {1, 0, 0})).x, 100 * std::cos(30 * kDegree),
              1e-12);
}

TEST(TruthSun, WithASizeMakesAPenumbraOfTheSegmentsOfItsDisc) {
  const double size = 4;
  const Yard yard(sunOf({0, 30, size}, 1));
  const TruthLight light(yard.level);
  for (const double degrees : {-1.9, -1.0, -0.3, 0.0, 0.7, 1.6}) {
    // From here the top of the wall stands so far above the middle of the disc.
    const double away = 3 / std::tan((30 + degrees) * kDegree);
    const double h = degrees / (size / 2);
    const double seen = (std::acos(h) - h * std::sqrt(1 - h * h)) / std::numbers::pi;
    EXPECT_NEAR(light.at(floorPoint(yard.yard, {40 - away, 20})).x, seen, 0.01) << degrees;
  }
}

TEST(TruthSun, ShinesThroughAnOpeningAndNotThroughACeiling) {
  TestLevel test;
  const SectorId room = test.addBox("room", {0, 0}, {8, 8}, {0, 3});
  const SectorId yard = test.addBox("yard", {8, 0}, {16, 8}, {0, 5});
  test.sector(yard).ceiling.isSky = true;
  test.link(room, yard);
  Level level = test.finished();
  level.lights = {sunOf({0, 20, 0})};
  const TruthLight light(level);
  // The yard's far wall is 5 m high, the opening 3 m.
  const double beyondWall = 16 - 5 / std::tan(20 * kDegree);
  const double beyondOpening = 8 - 3 / std::tan(20 * kDegree);
  EXPECT_EQ(light.at(floorPoint(room, {beyondWall - 1e-6, 4})).x, 255);
  EXPECT_EQ(light.at(floorPoint(room, {beyondWall + 1e-6, 4})).x, 0);
  EXPECT_EQ(light.at(floorPoint(room, {beyondOpening + 1e-6, 4})).x, 255);
  EXPECT_LT(beyondOpening, beyondWall);
  const AirPoint air{{7, 4, 2}, room};
  EXPECT_EQ(light.at(air).x, 255) << "a point of air takes its light without a cosine";
}

TEST(TruthSun, EndsInTheStepBetweenSkiesOfDifferentHeight) {
  TestLevel test;
  const SectorId high = test.addBox("high", {0, 0}, {8, 8}, {0, 8});
  const SectorId low = test.addBox("low", {8, 0}, {16, 8}, {0, 3});
  test.sector(high).ceiling.isSky = true;
  test.sector(low).ceiling.isSky = true;
  test.link(high, low);
  Level level = test.finished();
  level.lights = {sunOf({0, 45, 0})};
  const TruthLight light(level);
  // Over the lower sector the line is 4 m up and above its sky: the sun is seen whatever is there.
  EXPECT_EQ(light.at(floorPoint(high, {4, 4})).x, 255);
}

TEST(TruthSun, CastsShadowsOfMeshes) {
  LitHall hall;
  hall.test.sector(hall.hall).ceiling.isSky = true;
  hall.addCube({4, 4});
  Level level = hall.test.finished();
  level.lights = {sunOf({0, 45, 0})};
  const TruthLight light(level);
  EXPECT_EQ(light.at(floorPoint(hall.hall, {3.5, 4.5})).x, 0);
  EXPECT_EQ(light.at(floorPoint(hall.hall, {2.9, 4.5})).x, 255);
  EXPECT_EQ(light.at(facePoint(level, 0, kBoxTop, {4.7, 4.5, 1})).x, 255);
  EXPECT_EQ(light.at(facePoint(level, 0, kBoxBottom, {4.5, 4.7, 0})).x, 0);
}

TEST(TruthSpot, FollowsTheProfileOfTheFileFormat) {
  LitHall hall;
  LightSource& lamp = hall.light({4, 4, 3}, 120);
  lamp.spot.emplace(0, -90, 20, 40);
  const TruthLight light(hall.test.finished());
  for (double degrees = 1; degrees < 50; degrees += 3) {
    const double away = 3 * std::tan(degrees * kDegree);
    const double t = std::clamp((std::cos(degrees * kDegree) - std::cos(40 * kDegree)) /
                                    (std::cos(20 * kDegree) - std::cos(40 * kDegree)),
                                0.0, 1.0);
    EXPECT_NEAR(light.at(floorPoint(hall.hall, {4 + away, 4})).x, 120 * t * t * (3 - 2 * t), 1e-9)
        << degrees;
  }
}

}  // namespace
}  // namespace hearth
