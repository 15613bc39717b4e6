// The cone of a spotlight.

#include "level/spot.h"

#include <gtest/gtest.h>

#include <random>

namespace hearth {
namespace {

TEST(SpotTest, PointsWhereItsAnglesSay) {
  EXPECT_EQ(Spot(0, 0, 10, 20).direction(), (Vec3{1, 0, 0}));
  EXPECT_EQ(Spot(90, 0, 10, 20).direction(), (Vec3{0, 1, 0}));
  EXPECT_EQ(Spot(123, -90, 10, 20).direction(), (Vec3{0, 0, -1}));
}

TEST(SpotTest, IsFullInsideAndDarkOutside) {
  const Spot spot(0, 0, 30, 60);
  EXPECT_EQ(spot.factor(1), 1);
  EXPECT_EQ(spot.factor(spot.cosInner()), 1);
  EXPECT_EQ(spot.factor(spot.cosOuter()), 0);
  EXPECT_EQ(spot.factor(-1), 0);
  EXPECT_DOUBLE_EQ(spot.factor((spot.cosInner() + spot.cosOuter()) / 2), 0.5);
  EXPECT_LT(spot.factor(0.51), 0.01) << "smooth at both ends";
  EXPECT_GT(spot.factor(0.86), 0.99);
}

TEST(SpotTest, MayJumpAtItsEdge) {
  const Spot spot(0, 0, 60, 60);
  EXPECT_EQ(spot.factor(0.5001), 1);
  EXPECT_EQ(spot.factor(0.4999), 0);
}

TEST(SpotTest, OfAHalfTurnShinesAllAround) {
  const Spot spot(40, 20, 180, 180);
  for (const double cosine : {-1.0 - 1e-15, -1.0, -0.5, 0.0, 1.0})
    EXPECT_EQ(spot.factor(cosine), 1);
}

TEST(SpotTest, TellsHowFarAPointIsOutsideItsCone) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto direction = [&] {
    Vec3 way;
    do way = {unit(random), unit(random), unit(random)};
    while (length(way) > 1 || length(way) < 1e-3);
    return 1 / length(way) * way;
  };
  int dark = 0;
  int lit = 0;
  for (int i = 0; i < 2000; ++i) {
    const double outer = 90 * (unit(random) + 1);
    const Spot spot(180 * unit(random), 90 * unit(random), outer / 2, outer);
    const Vec3 offset = 4 * direction();
    const double radius = 1 + unit(random);
    bool lightsAPoint = false;
    for (int k = 0; k < 200; ++k) lightsAPoint |= spot.factor(offset + radius * direction()) > 0;
    const bool mayLight = spot.beyondEdge(offset) <= radius + 1e-12;
    EXPECT_TRUE(mayLight || !lightsAPoint) << i;
    EXPECT_EQ(spot.beyondEdge(offset) < 0, spot.factor(offset) > 0) << i;
    dark += mayLight ? 0 : 1;
    lit += lightsAPoint ? 1 : 0;
  }
  EXPECT_GT(dark, 0.95 * (2000 - lit)) << "most of what is dark";
}

}  // namespace
}  // namespace hearth
