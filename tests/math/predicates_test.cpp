#include "math/predicates.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hearth {
namespace {

TEST(Orientation, isPositiveInFrontOfASegment) {
  // Looking along +x on a map with y down, the front is at +y: to the right.
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0.5, 1}), 1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0.5, -1}), -1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {7, 0}), 0);
}

TEST(Orientation, decidesWhatRoundingCannot) {
  // A point one ulp off the diagonal, far from the origin: the plain determinant rounds to 0.
  const Vec2 a{0.5, 0.5};
  const Vec2 b{12, 12};
  const Vec2 c{24, 24};
  EXPECT_EQ(orientation(a, b, c), 0);
  EXPECT_EQ(orientation(a, b, {24, std::nextafter(24, 25)}), 1);
  EXPECT_EQ(orientation(a, b, {24, std::nextafter(24, 23)}), -1);
}

TEST(Orientation, isAntisymmetricForNearlyCollinearPoints) {
  for (int i = 0; i < 1000; ++i) {
    const double x = 1e7 + i * 0.1;
    const Vec2 a{x, x / 3};
    const Vec2 b{x + 1, (x + 1) / 3};
    const Vec2 c{x + 2, (x + 2) / 3};
    EXPECT_EQ(orientation(a, b, c), -orientation(b, a, c)) << i;
    EXPECT_EQ(orientation(a, b, c), orientation(b, c, a)) << i;
  }
}

TEST(MeetsFirst, ordersWallsAlongARay) {
  const Vec2 eye{0, 0};
  EXPECT_TRUE(meetsFirst(eye, {1, -1}, {1, 1}, {2, -1}, {2, 1}));
  EXPECT_FALSE(meetsFirst(eye, {2, -1}, {2, 1}, {1, -1}, {1, 1}));
}

TEST(MeetsFirst, ordersWallsThatShareAVertex) {
  const Vec2 eye{0, 0};
  const Vec2 shared{10, 0};
  const Vec2 nearEnd{9.999999999, 5};
  const Vec2 farEnd{10.000000001, 5};
  EXPECT_TRUE(meetsFirst(eye, shared, nearEnd, farEnd, shared));
  EXPECT_FALSE(meetsFirst(eye, farEnd, shared, shared, nearEnd));
}

TEST(MeetsFirst, isFalseBothWaysForTheSameWall) {
  const Vec2 eye{0, 0};
  EXPECT_FALSE(meetsFirst(eye, {1, -1}, {1, 1}, {1, 1}, {1, -1}));
  EXPECT_FALSE(meetsFirst(eye, {1, 1}, {1, -1}, {1, -1}, {1, 1}));
}

TEST(NearestOnSegment, staysBetweenTheEnds) {
  EXPECT_EQ(nearestOnSegment({0, 0}, {2, 0}, {1, 5}), (Vec2{1, 0}));
  EXPECT_EQ(nearestOnSegment({0, 0}, {2, 0}, {-3, 1}), (Vec2{0, 0}));
  EXPECT_EQ(nearestOnSegment({0, 0}, {2, 0}, {9, 1}), (Vec2{2, 0}));
  EXPECT_EQ(nearestOnSegment({1, 1}, {1, 1}, {9, 1}), (Vec2{1, 1})) << "a segment of no length";
}

}  // namespace
}  // namespace hearth
