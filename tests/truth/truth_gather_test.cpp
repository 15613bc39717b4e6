// Light from areas and light that bounces, against closed forms.

#include "truth/truth_gather.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "lit_hall.h"
#include "mesh_shapes.h"
#include "test_level.h"

namespace hearth {
namespace {

/// All textures reflect so much.
Level withReflectance(const TestLevel& test, double reflectance, int bounces) {
  Level level = test.level();
  level.reflectances.assign(level.textures.size(), {reflectance, reflectance, reflectance});
  level.bake.bounces = bounces;
  return level;
}

void addEmitter(Level& level, const std::string& texture, double intensity) {
  LightSource emitter;
  emitter.texture = texture;
  emitter.intensity = intensity;
  level.lights.push_back(emitter);
}

void makeAllShine(Level& level, double intensity) {
  for (const std::string& texture : level.textures) addEmitter(level, texture, intensity);
}

void addSky(Level& level, double intensity) {
  LightSource sky;
  sky.isSky = true;
  sky.intensity = intensity;
  level.lights.push_back(sky);
}

double geometricSum(double reflectance, int bounces) {
  double sum = 0;
  for (int k = 0; k <= bounces; ++k) sum += std::pow(reflectance, k);
  return sum;
}

/// A point of each solid wall, and of the floor and the ceiling a little before it.
std::vector<SurfacePoint> placesIn(const Level& level) {
  std::vector<SurfacePoint> places;
  for (std::size_t i = 0; i < level.sectors.size(); ++i) {
    const Sector& sector = level.sectors[i];
    for (std::size_t k = 0; k < sector.segmentCount; ++k) {
      const SegmentId id(sector.firstSegment.index() + k);
      const Segment& wall = level[id];
      if (!std::holds_alternative<Solid>(wall.wall)) continue;
      const Vec2 middle = lerp(wall.p0, wall.p1, 0.4);
      const Vec2 normal = (1 / length(wall.p1 - wall.p0)) * turned90(wall.p1 - wall.p0);
      const double z = 0.7 * sector.floor.z + 0.3 * sector.ceiling.z;
      places.push_back(
          {SurfaceKind::Solid, SectorId(i), id, {middle.x, middle.y, z}, {normal.x, normal.y, 0}});
      const Vec2 before = middle + 0.1 * normal;
      places.push_back({SurfaceKind::Floor,
                        SectorId(i),
                        std::nullopt,
                        {before.x, before.y, sector.floor.z},
                        {0, 0, 1}});
      places.push_back({SurfaceKind::Ceiling,
                        SectorId(i),
                        std::nullopt,
                        {before.x, before.y, sector.ceiling.z},
                        {0, 0, -1}});
    }
  }
  return places;
}

constexpr TruthGather::Effort kFewRays{.side = 4, .rounds = 2};

/// Where every ray brings the same there is no error at all.
void expectEverywhere(const Level& level, double sum, const std::vector<SurfacePoint>& places) {
  const TruthLight direct(level);
  const TruthGather gather(level, direct);
  for (const SurfacePoint& place : places) {
    const double found = direct.at(place).x + gather.at(place, kFewRays).light.sum().x;
    EXPECT_NEAR(found, sum, 1e-9 * sum) << place.point.x << " " << place.point.y;
  }
}

TEST(TruthGather, AClosedBoxWithALampHasTheGeometricSum) {
  LitHall hall;
  hall.light({3, 5, 2}, 40);
  hall.test.finished();
  for (const int bounces : {0, 1, 3, 16}) {
    const Level level = withReflectance(hall.test, 0.6, bounces);
    expectEverywhere(level, 40 * geometricSum(0.6, bounces), placesIn(level));
  }
}

TEST(TruthGather, AnLShapeWithALampInItsCornerHasTheGeometricSum) {
  TestLevel test;
  const SectorId room = test.addSector("room", {0, 3});
  test.addLoop(room, {{0, 0}, {8, 0}, {8, 3}, {3, 3}, {3, 8}, {0, 8}});
  test.addLight(room, {1.5, 1.5, 1.5}, 50);
  test.finished();
  const Level level = withReflectance(test, 0.5, 4);
  expectEverywhere(level, 50 * geometricSum(0.5, 4), placesIn(level));
}

TEST(TruthGather, WhateverShinesAllAroundHasItsOwnLightAndTheGeometricSum) {
  // A room with a pillar, another beside it and one over both: a flat portal between.
  TestLevel test;
  const SectorId room = test.addSector("room", {0, 3});
  test.addLoop(room, {{0, 0}, {6, 0}, {6, 6}, {0, 6}});
  test.addLoop(room, {{2, 2}, {2, 4}, {4, 4}, {4, 2}});
  const SectorId side = test.addBox("side", {6, 0}, {10, 6}, {-1, 3});
  const SectorId upper = test.addBox("upper", {0, 0}, {6, 6}, {3, 5});
  test.link(room, side);
  test.connect({upper}, {room});
  test.finished();
  Level level = withReflectance(test, 0.7, 3);
  makeAllShine(level, 20);
  std::vector<SurfacePoint> places;
  for (const SurfacePoint& place : placesIn(level))
    if (!(place.kind == SurfaceKind::Ceiling && place.sector == room) &&
        !(place.kind == SurfaceKind::Floor && place.sector == upper))
      places.push_back(place);
  expectEverywhere(level, 20 * geometricSum(0.7, 3), places);
}

TEST(TruthGather, ReflectsNoMoreThanItMay) {
  LitHall hall;
  hall.light({3, 5, 2}, 10);
  hall.test.finished();
  Level level = withReflectance(hall.test, 1, 2);
  expectEverywhere(level, 10 * geometricSum(0.95, 2), placesIn(level));
  level.bake.reflectance = 0.5;
  expectEverywhere(level, 10 * geometricSum(0.5, 2), placesIn(level));
}

TEST(TruthGather, ReflectsInTheColourOfATexture) {
  LitHall hall;
  hall.light({3, 5, 2}, 100);
  hall.test.finished();
  Level level = withReflectance(hall.test, 0, 2);
  level.reflectances.assign(level.textures.size(), {0.5, 0.25, 0});
  const TruthLight direct(level);
  const Vec3 bounced =
      TruthGather(level, direct).at(floorPoint(hall.hall, {2, 2}), kFewRays).light.bounced;
  EXPECT_NEAR(bounced.x, 75, 1e-9);
  EXPECT_NEAR(bounced.y, 31.25, 1e-9);
  EXPECT_EQ(bounced.z, 0);
}

// --- Form factors --------------------------------------------------------------------------------

/// What a rectangle of a x b, `c` above its corner and parallel to the ground, fills there of the
/// integral of the cosine (J. Howell, "A Catalog of Radiation Configuration Factors", B-4 and B-3).
double parallelFactor(double a, double b, double c) {
  const double x = a / c;
  const double y = b / c;
  const double rx = std::sqrt(1 + x * x);
  const double ry = std::sqrt(1 + y * y);
  return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * std::numbers::pi);
}

/// Of one that stands upright at the distance `c`, `a` high and `b` wide from the foot on.
double uprightFactor(double a, double b, double c) {
  const double x = b / c;
  const double y = a / c;
  const double r = std::sqrt(1 + y * y);
  return (std::atan(x) - 1 / r * std::atan(x / r)) / (2 * std::numbers::pi);
}

void expectWithin(const TruthGather::Estimate& found, double Vec3::*channel, double expected,
                  const char* what) {
  const double sum = found.light.sum().*channel;
  const double error = found.standardError.sum().*channel;
  EXPECT_NEAR(sum, expected, 4 * error + 1e-9) << what;
  EXPECT_LT(error, 0.004 * 100) << what;
}

TEST(TruthGather, ACeilingThatShinesGivesTheFormFactorsOfRectangles) {
  LitHall hall;
  hall.test.finished();
  Level level = hall.test.level();
  addEmitter(level, level.textures[level[hall.hall].ceiling.texture->texture.index()], 100);
  const TruthLight direct(level);
  const TruthGather gather(level, direct);
  const double below = parallelFactor(3, 2, 4) + parallelFactor(5, 2, 4) + parallelFactor(3, 6, 4) +
                       parallelFactor(5, 6, 4);
  expectWithin(gather.at(floorPoint(hall.hall, {3, 2})), &Vec3::x, 100 * below, "floor");
  // At a wall the ceiling, 4 - 1 m above, reaches 8 m away and 3 and 5 m to the sides.
  const SurfacePoint onWall{
      SurfaceKind::Solid, hall.hall, hall.test.wallId(hall.hall, 0), {3, 0, 1}, {0, 1, 0}};
  const double above = uprightFactor(8, 3, 3) + uprightFactor(8, 5, 3);
  expectWithin(gather.at(onWall), &Vec3::x, 100 * above, "wall");
}

TEST(TruthGather, LevelGroundInTheOpenHasTheIntensityOfTheSky) {
  TestLevel test;
  const SectorId plain = test.addBox("plain", {-500, -500}, {500, 500}, {0, 0.01});
  test.sector(plain).ceiling.isSky = true;
  Level level = test.finished();
  addSky(level, 120);
  level.lights.back().color[1] = 102;
  level.lights.back().color[2] = 51;
  const TruthLight direct(level);
  const Vec3 sky = TruthGather(level, direct).at(floorPoint(plain, {0, 0})).light.sky;
  EXPECT_NEAR(sky.x, 120, 0.05);
  EXPECT_NEAR(sky.y, 48, 0.05);
  EXPECT_NEAR(sky.z, 24, 0.05);
}

TEST(TruthGather, ASkyThroughAShaftHasTheFormFactorOfItsOpening) {
  TestLevel test;
  const SectorId shaft = test.addBox("shaft", {0, 0}, {2, 3}, {0, 5});
  test.sector(shaft).ceiling.isSky = true;
  Level level = test.finished();
  addSky(level, 100);
  const TruthLight direct(level);
  const TruthGather gather(level, direct);
  const double opening = parallelFactor(0.5, 1, 5) + parallelFactor(1.5, 1, 5) +
                         parallelFactor(0.5, 2, 5) + parallelFactor(1.5, 2, 5);
  expectWithin(gather.at(floorPoint(shaft, {0.5, 1})), &Vec3::x, 100 * opening, "floor");
}

TEST(TruthGather, AStepBetweenSkiesIsSky) {
  TestLevel test;
  const SectorId high = test.addBox("high", {0, 0}, {4, 4}, {0, 4});
  const SectorId low = test.addBox("low", {4, 0}, {8, 4}, {0, 1});
  test.sector(high).ceiling.isSky = true;
  test.sector(low).ceiling.isSky = true;
  test.link(high, low);
  Level level = test.finished();
  addSky(level, 100);
  const TruthLight direct(level);
  const TruthGather gather(level, direct);
  // From the wall across, at the height of the lower sky: the step and the ceiling are sky.
  const SurfacePoint place{SurfaceKind::Solid, high, test.wallId(high, 3), {0, 2, 1}, {1, 0, 0}};
  const double step = 2 * parallelFactor(3, 2, 4);
  const double ceiling = 2 * uprightFactor(4, 2, 3);
  expectWithin(gather.at(place), &Vec3::x, 100 * (step + ceiling), "sky");
}

TEST(TruthGather, AllThatAnEmitterGivesIsTaken) {
  LitHall hall;
  hall.test.finished();
  Level level = hall.test.level();
  addEmitter(level, level.textures[level[hall.hall].floor.texture->texture.index()], 100);
  const TruthLight direct(level);
  const TruthGather gather(level, direct);
  double taken = 0;
  constexpr int kSide = 12;
  const auto add = [&](double area, auto&& placeAt) {
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j)
        taken += area / (kSide * kSide) *
                 gather.at(placeAt((i + 0.5) / kSide, (j + 0.5) / kSide), {.side = 12, .rounds = 2})
                     .light.emitted.x;
  };
  add(64, [&](double u, double v) {
    return SurfacePoint{
        SurfaceKind::Ceiling, hall.hall, std::nullopt, {8 * u, 8 * v, 4}, {0, 0, -1}};
  });
  add(4 * 32, [&](double u, double v) {  // by symmetry
    return SurfacePoint{SurfaceKind::Solid,
                        hall.hall,
                        hall.test.wallId(hall.hall, 0),
                        {8 * u, 0, 4 * v},
                        {0, 1, 0}};
  });
  EXPECT_NEAR(taken, 100 * 64, 0.005 * 100 * 64);
}

TEST(TruthGather, APointOfAirTakesHalfOfAnOpenSky) {
  TestLevel test;
  const SectorId plain = test.addBox("plain", {-500, -500}, {500, 500}, {0, 1});
  test.sector(plain).ceiling.isSky = true;
  Level level = test.finished();
  addSky(level, 100);
  const TruthLight direct(level);
  const auto found = TruthGather(level, direct).at(AirPoint{{0, 0, 0.999}, plain});
  EXPECT_NEAR(found.light.sky.x, 50, 0.3);
}

TEST(TruthGather, MeshesHideWhatIsBehindThemAndShine) {
  LitHall hall;
  const std::vector<MeshFace> lid =
      tableAt(2, {1, 1}, {3, 3}, hall.test.texture().texture);  // its front looks up
  hall.add(lid);
  hall.test.finished();
  Level level = hall.test.level();
  addEmitter(level, level.textures[level[hall.hall].ceiling.texture->texture.index()], 100);
  const TruthLight direct(level);
  const auto below = TruthGather(level, direct).at(floorPoint(hall.hall, {2, 2}));
  const double ceiling =
      parallelFactor(2, 2, 4) + 2 * parallelFactor(6, 2, 4) + parallelFactor(6, 6, 4);
  const double hidden = 4 * parallelFactor(1, 1, 2);
  expectWithin(below, &Vec3::x, 100 * (ceiling - hidden), "below a table");
  level.lights.clear();
  addEmitter(level, level.textures[lid.front().texture.index()], 100);
  const SurfacePoint above{SurfaceKind::Ceiling, hall.hall, std::nullopt, {2, 2, 4}, {0, 0, -1}};
  expectWithin(TruthGather(level, direct).at(above), &Vec3::x, 100 * hidden, "above it");
  EXPECT_EQ(TruthGather(level, direct).at(floorPoint(hall.hall, {2, 2})).light.emitted.x, 0)
      << "its back does not shine";
}

TEST(TruthGather, IsTheSameForTheSameSeed) {
  LitHall hall;
  hall.light({3, 5, 2}, 40, 1);
  hall.test.finished();
  const Level level = withReflectance(hall.test, 0.6, 2);
  const TruthLight direct(level);
  const TruthGather gather(level, direct);
  const SurfacePoint place = floorPoint(hall.hall, {2, 2});
  const double first = gather.at(place, kFewRays).light.bounced.x;
  gather.at(floorPoint(hall.hall, {5, 2}), kFewRays);
  EXPECT_EQ(gather.at(place, kFewRays).light.bounced.x, first);
  TruthGather::Effort other = kFewRays;
  other.seed = 2;
  EXPECT_NE(gather.at(place, other).light.bounced.x, first);
}

}  // namespace
}  // namespace hearth
