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

/// Two rooms with a wall 6 m thick between them, and lights in the first: a square, or an L with a
/// shadow round its corner.
test::BakedRoom twoRooms(const std::string& lights, int threads = 2,
                         const char* first = "0,0, 4,0, 4,4, 0,4") {
  return {"{'light': 0.1, 'sectors': {" + test::sectorText("a", first, 0, 3) + "," +
              test::sectorText("b", "10,0, 14,0, 14,4, 10,4", 0, 3) + "}}",
          lights, threads};
}
constexpr const char* kL = "0,0, 4,0, 4,4, 2,4, 2,2, 0,2";

TEST(BakeCost, ofSurfacesAndLightsIsTheSameSumForAnyNumberOfThreads) {
  const char* lights = "[{'x':1,'y':1,'z':2},{'x':3,'y':2,'z':1,'radius':0.2},{'x':3,'y':3,'z':1}]";
  const test::BakedRoom one = twoRooms(lights, 1, kL);
  EXPECT_GT(one.light().stats.rays, 0);
  for (const int threads : {1, 2, 7}) {
    const test::BakedRoom many = twoRooms(lights, threads, kL);
    EXPECT_EQ(raysOfSurfaces(many.light()), one.light().stats.rays);
    EXPECT_EQ(raysOfLights(many.light()), one.light().stats.rays);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(many.light().lightCosts[i].rays, one.light().lightCosts[i].rays);
      EXPECT_EQ(many.light().lightCosts[i].seenSamples, one.light().lightCosts[i].seenSamples);
    }
  }
}

TEST(BakeCost, isNoRaysWhereAllOfALightArrivesOrNoneCanCome) {
  for (const char* light : {"[{'x':1,'y':1,'z':2}]", "[{'x':1,'y':1,'z':2,'radius':0.1}]"}) {
    const LightCost cost = twoRooms(light).light().lightCosts.at(0);
    EXPECT_GT(cost.samples, 0);
    EXPECT_GT(cost.seenSamples, 0);
    EXPECT_LT(cost.seenSamples, cost.samples) << "the other room sees nothing of it";
    EXPECT_EQ(cost.rays, 0);
  }
}

TEST(BakeCost, ofASpotIsOfWhatLiesNearItsCone) {
  for (const char* radius : {"0", "0.1"}) {
    const std::string lamp = std::string("[{'x':1,'y':1,'z':2,'radius':") + radius;
    const LightCost all = twoRooms(lamp + "}]").light().lightCosts.at(0);
    const LightCost spot =
        twoRooms(lamp + ",'spot':{'pitch':-90,'outer':25}}]").light().lightCosts.at(0);
    EXPECT_LT(spot.samples, all.samples / 2);
    EXPECT_LT(spot.seenSamples, spot.samples) << "no more than its cone counts as seen";
    EXPECT_GT(spot.seenSamples, 0);
    const LightCost needle =
        twoRooms(lamp + ",'spot':{'pitch':-90,'outer':0.01}}]").light().lightCosts.at(0);
    EXPECT_EQ(needle.seenSamples, 0) << "no sample lies in it";
  }
}

TEST(BakeCost, isRaysAtTheEdgeOfAShadowAndOfABallMore) {
  const auto costOf = [](const std::string& lights) {
    return twoRooms(lights, 2, kL).light().lightCosts.at(0);
  };
  const LightCost point = costOf("[{'x':1,'y':1,'z':2}]");
  EXPECT_GT(point.rays, 0);
  EXPECT_LT(point.rays, point.samples / 4);
  const LightCost ball = costOf("[{'x':1,'y':1,'z':2,'radius':0.1}]");
  EXPECT_EQ(ball.samples, point.samples);
  EXPECT_GT(ball.rays, 10 * point.rays);
}

TEST(BakeCost, ofASurfaceThatNoLightFacesIsNothing) {
  const test::BakedRoom rooms = twoRooms("[{'x':1,'y':1,'z':2}]");
  const auto west = rooms.surfaceAt(SurfaceKind::Solid, {10, 2, 1}, "b");
  const auto east = rooms.surfaceAt(SurfaceKind::Solid, {14, 2, 1}, "b");
  EXPECT_EQ(rooms.light().surfaceCosts[west.value().index()].facingLights, 0U);
  EXPECT_EQ(rooms.light().surfaceCosts[west.value().index()].rays, 0);
  EXPECT_EQ(rooms.light().surfaceCosts[east.value().index()].facingLights, 1U);
}

TEST(BakeCost, ofASurfaceThatNoLightReachesIsNothing) {
  // A hall of 40 m with a pillar; the light ends 6 m from its middle.
  const test::BakedRoom hall(
      "{'light': 0.1, 'sectors': {" +
          test::sectorText("hall", "0,0, 40,0, 40,4, 20,4, 20,3, 18,3, 18,4, 0,4", 0, 3) + "}}",
      "[{'x':2,'y':2,'z':2,'curve':[[0,255],[6,0]]}]");
  const auto costAt = [&](Vec3 p) {
    return hall.light().surfaceCosts[hall.surfaceAt(SurfaceKind::Solid, p, "")->index()];
  };
  EXPECT_EQ(costAt({0, 2, 1}).facingLights, 1U);
  for (const Vec3 far : {Vec3{40, 2, 1}, Vec3{18, 3.5, 1}, Vec3{19, 3, 1}}) {
    EXPECT_EQ(costAt(far).facingLights, 0U) << far.x;
    EXPECT_EQ(costAt(far).rays, 0) << far.x;
  }
  // Of long surfaces only the tiles of texels that it reaches are tested.
  const std::int64_t texelsAcross = 40 * 8;
  EXPECT_LT(hall.light().lightCosts[0].samples, texelsAcross * (4 + 4 + 3 + 3) * 8 / 2);
}

}  // namespace
}  // namespace hearth
