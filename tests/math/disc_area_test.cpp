#include "math/disc_area.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace hearth {
namespace {

std::array<Vec2, 4> rectangle(Vec2 min, Vec2 max) {
  return {min, {max.x, min.y}, max, {min.x, max.y}};
}

TEST(DiscArea, IsThatOfAPolygonInside) {
  EXPECT_DOUBLE_EQ(areaInUnitDisc(rectangle({-0.5, -0.25}, {0.5, 0.5})), 0.75);
}

TEST(DiscArea, IsThatOfTheDiscInAPolygonAroundIt) {
  EXPECT_NEAR(areaInUnitDisc(rectangle({-2, -3}, {4, 1.5})), std::numbers::pi, 1e-14);
}

TEST(DiscArea, IsThatOfASegmentBehindALine) {
  for (const double h : {-0.9, -0.3, 0.0, 0.4, 0.99}) {
    const double segment = std::acos(h) - h * std::sqrt(1 - h * h);
    EXPECT_NEAR(areaInUnitDisc(rectangle({-2, h}, {2, 2})), segment, 1e-14) << h;
  }
}

TEST(DiscArea, IsNoneBesideTheDisc) {
  EXPECT_NEAR(areaInUnitDisc(rectangle({0.8, 0.8}, {2, 2})), 0, 1e-15);
  EXPECT_EQ(areaInUnitDisc({}), 0);
}

TEST(DiscArea, OfCellsIsTheDiscTogether) {
  double sum = 0;
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) {
      const Vec2 min{2.0 / 7 * i - 1, 2.0 / 7 * j - 1};
      sum += areaInUnitDisc(rectangle(min, min + Vec2{2.0 / 7, 2.0 / 7}));
    }
  EXPECT_NEAR(sum, std::numbers::pi, 1e-13);
}

}  // namespace
}  // namespace hearth
