#include "load/link/plane_fit.h"

#include <gtest/gtest.h>

#include <vector>

namespace hearth {
namespace {

TEST(PlaneFit, isExactForLevelAndAxisParallelWedges) {
  const std::vector<Vec3> level{{0, 0, 0.1}, {3, 0, 0.1}, {3, 7, 0.1}, {0, 7, 0.1}};
  const PlaneFit flat = fitPlane(level, {0, 0}, 1e-3).value();
  EXPECT_EQ(flat.gradient, (Vec2{0, 0}));
  EXPECT_EQ(flat.zAtOrigin, 0.1);
  const std::vector<Vec3> wedge{{0, 0, 0}, {4, 0, 1}, {4, 4, 1}, {0, 4, 0}};
  const PlaneFit fit = fitPlane(wedge, {0, 0}, 1e-3).value();
  EXPECT_EQ(fit.gradient, (Vec2{0.25, 0}));
  EXPECT_EQ(fit.zAtOrigin, 0);
  EXPECT_EQ(fit.worstMiss, 0);
}

TEST(PlaneFit, leavesTheLeastSquares) {
  // One corner of four too high by e: the best plane misses each corner by e/4.
  const std::vector<Vec3> corners{{0, 0, 0.4}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_NEAR(fitPlane(corners, {0, 0}, 1e-3).value().worstMiss, 0.1, 1e-15);
}

TEST(PlaneFit, holdsForNearlyVerticalWedges) {
  const std::vector<Vec3> wedge{{0, 0, 0}, {1, 0, 1e6}, {1, 1, 1e6}, {0, 1, 0}};
  const PlaneFit fit = fitPlane(wedge, {0, 0}, 1e-3).value();
  EXPECT_EQ(fit.gradient, (Vec2{1e6, 0}));
  EXPECT_LE(fit.worstMiss, 1e-9);
}

TEST(PlaneFit, holdsFarFromTheOrigin) {
  const std::vector<Vec3> wedge{{1e7, 1e7, 5}, {1e7 + 1, 1e7, 6}, {1e7, 1e7 + 1, 5}};
  const PlaneFit fit = fitPlane(wedge, {1e7, 1e7}, 1e-3).value();
  EXPECT_NEAR(fit.gradient.x, 1, 1e-12);
  EXPECT_NEAR(fit.gradient.y, 0, 1e-12);
  EXPECT_NEAR(fit.zAtOrigin, 5, 1e-12);
}

TEST(PlaneFit, needsThreePointsThatAreNotInLine) {
  EXPECT_FALSE(fitPlane(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}, {0, 0}, 1e-3));
  EXPECT_FALSE(fitPlane(std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {2, 2, 1}}, {0, 0}, 1e-3));
  EXPECT_FALSE(fitPlane(std::vector<Vec3>{{0, 0, 0}, {1, 0.0005, 0}, {2, 0, 1}}, {0, 0}, 1e-3));
}

}  // namespace
}  // namespace hearth
