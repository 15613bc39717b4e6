#include <gtest/gtest.h>

#include <numeric>

#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

std::int64_t raysOfSurfaces(const BakedLight& light) {
  return std::accumulate(light.surfaceCosts.begin(), light.surfaceCosts.end(), std::int64_t{0},
                         [](auto sum, const SurfaceCost& cost) { return sum + cost.rays; });
}

std::int64_t raysOfLights(const BakedLight& light) {
  return std::accumulate(light.lightCosts.begin(), light.lightCosts.end(), std::int64_t{0},
                         [](auto sum, const LightCost& cost) { return sum + cost.rays; });
}

/// Two rooms with a wall 6 m thick between them, and lights in the first.
test::BakedRoom twoRooms(const std::string& lights, int threads = 2) {
  return {"{'light': 0.1, 'sectors': {" + test::sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3) + "," +
              test::sectorText("b", "10,0, 14,0, 14,4, 10,4", 0, 3) + "}}",
          lights, threads};
}

TEST(BakeCost, ofSurfacesAndLightsIsTheSameSumForAnyNumberOfThreads) {
  const char* lights = "[{'x':1,'y':1,'z':2},{'x':3,'y':2,'z':1,'radius':0.2},{'x':2,'y':3,'z':1}]";
  const test::BakedRoom one = twoRooms(lights, 1);
  EXPECT_GT(one.light().stats.rays, 0);
  for (const int threads : {1, 2, 7}) {
    const test::BakedRoom many = twoRooms(lights, threads);
    EXPECT_EQ(raysOfSurfaces(many.light()), one.light().stats.rays);
    EXPECT_EQ(raysOfLights(many.light()), one.light().stats.rays);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(many.light().lightCosts[i].rays, one.light().lightCosts[i].rays);
      EXPECT_EQ(many.light().lightCosts[i].seenSamples, one.light().lightCosts[i].seenSamples);
    }
  }
}

TEST(BakeCost, ofAPointIsARayASampleAndOfABallMore) {
  const auto costOf = [](const std::string& lights) {
    return twoRooms(lights).light().lightCosts.at(0);
  };
  const LightCost point = costOf("[{'x':1,'y':1,'z':2}]");
  EXPECT_GT(point.samples, 0);
  EXPECT_EQ(point.rays, point.samples);
  EXPECT_LT(point.seenSamples, point.samples) << "the other room sees nothing of it";
  const LightCost ball = costOf("[{'x':1,'y':1,'z':2,'radius':0.1}]");
  EXPECT_EQ(ball.samples, point.samples);
  EXPECT_GT(ball.rays, 10 * ball.samples);
}

TEST(BakeCost, ofASurfaceThatNoLightFacesIsNothing) {
  const test::BakedRoom rooms = twoRooms("[{'x':1,'y':1,'z':2}]");
  const auto west = rooms.surfaceAt(SurfaceKind::Solid, {10, 2, 1}, "b");
  const auto east = rooms.surfaceAt(SurfaceKind::Solid, {14, 2, 1}, "b");
  EXPECT_EQ(rooms.light().surfaceCosts[west.value().index()].facingLights, 0U);
  EXPECT_EQ(rooms.light().surfaceCosts[west.value().index()].rays, 0);
  EXPECT_EQ(rooms.light().surfaceCosts[east.value().index()].facingLights, 1U);
  EXPECT_GT(rooms.light().surfaceCosts[east.value().index()].rays, 0);
}

}  // namespace
}  // namespace hearth
