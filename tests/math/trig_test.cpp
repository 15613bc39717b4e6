#include "math/trig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hearth {
namespace {

TEST(Trig, agreesWithLongDoubles) {
  const long double radians = std::acos(-1.0L) / 180;
  for (double angle = -720; angle <= 720; angle += 0.37) {
    const SinCos found = sinCosDegrees(angle);
    EXPECT_NEAR(found.sin, static_cast<double>(std::sin(angle * radians)), 4e-16) << angle;
    EXPECT_NEAR(found.cos, static_cast<double>(std::cos(angle * radians)), 4e-16) << angle;
  }
}

TEST(Trig, isExactAtQuarterTurns) {
  for (int turn = -8; turn <= 8; ++turn) {
    const SinCos found = sinCosDegrees(90.0 * turn);
    EXPECT_EQ(std::abs(found.sin), turn % 2 == 0 ? 0 : 1) << turn;
    EXPECT_EQ(std::abs(found.cos), turn % 2 == 0 ? 1 : 0) << turn;
  }
}

TEST(Trig, wrapsAnglesIntoOneTurn) {
  EXPECT_EQ(wrappedDegrees(0), 0);
  EXPECT_EQ(wrappedDegrees(360), 0);
  EXPECT_EQ(wrappedDegrees(-90), 270);
  EXPECT_EQ(wrappedDegrees(725), 5);
  EXPECT_EQ(wrappedDegrees(-1e-300), 0);
}

TEST(Trig, tangentReachesTheWidestFieldOfView) {
  EXPECT_NEAR(tanDegrees(45), 1, 1e-15);
  EXPECT_NEAR(tanDegrees(89.5) / 114.58865012930961, 1, 1e-12);
}

TEST(Compass, runsFromXTowardsYAndStaysBelow360) {
  EXPECT_EQ(compassDegrees({1, 0}), 0);
  EXPECT_EQ(compassDegrees({0, 1}), 90);
  EXPECT_EQ(compassDegrees({-1, 0}), 180);
  EXPECT_EQ(compassDegrees({0, -1}), 270);
  EXPECT_EQ(compassDegrees({0, 0}), 0);
  EXPECT_LT(compassDegrees({1, -1e-300}), 360);
  for (double angle = 0.5; angle < 360; angle += 0.7) {
    const SinCos at = sinCosDegrees(angle);
    EXPECT_NEAR(compassDegrees({at.cos, at.sin}), angle, 1e-12);
  }
}

}  // namespace
}  // namespace hearth
