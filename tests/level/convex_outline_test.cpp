#include "level/convex_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {
namespace {

using Points = std::vector<Vec2>;

bool isLine(const ConvexOutline& outline) { return outline.corners().size() == 3; }

Points cornersOf(const ConvexOutline& outline) {
  return {outline.corners().begin(), outline.corners().end()};
}

double distanceToEdges(const ConvexOutline& outline, Vec2 p) {
  const auto corners = outline.corners();
  double least = length(corners[0] - p);
  for (std::size_t i = 1; i < corners.size(); ++i)
    least = std::min(least, length(nearestOnSegment(corners[i - 1], corners[i], p) - p));
  return least;
}

bool isInside(const ConvexOutline& outline, Vec2 p) {
  const auto corners = outline.corners();
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (orientation(corners[i - 1], corners[i], p) >= 0) return false;
  return corners.size() > 1;
}

class RandomPoints {
 public:
  Vec2 point() { return {coordinate_(random_), coordinate_(random_)}; }
  Points points(std::size_t count) {
    Points points(count);
    for (Vec2& p : points) p = point();
    return points;
  }
  /// On a coarse grid, so that many lie in line, or at one place.
  Points onGrid(std::size_t count) {
    Points points = this->points(count);
    for (Vec2& p : points) p = {std::round(2 * p.x), std::round(2 * p.y)};
    return points;
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> coordinate_{-1, 1};
};

TEST(ConvexOutlines, GoCounterClockwiseOnTheMapFromTheLeftmostCorner) {
  const ConvexOutline square({{1, 1}, {0, 0}, {0.5, 0.5}, {1, 0}, {0, 1}, {0, 0.5}, {1, 1}});
  EXPECT_EQ(cornersOf(square), (Points{{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}}));
  EXPECT_EQ(square.box(), (Box{{0, 0}, {1, 1}}));
  EXPECT_FALSE(isLine(square));
}

TEST(ConvexOutlines, AreLinesAndPointsWhereTheyHaveNoBreadth) {
  EXPECT_EQ(cornersOf(ConvexOutline({{2, 3}})), (Points{{2, 3}}));
  EXPECT_EQ(cornersOf(ConvexOutline({{2, 3}, {2, 3}, {2, 3 + 1e-7}})).size(), 1U);
  const ConvexOutline line({{3, 1}, {1, 3}, {2, 2}, {1.5, 2.5 + 1e-8}});
  EXPECT_EQ(cornersOf(line), (Points{{1, 3}, {3, 1}, {1, 3}}));
  EXPECT_TRUE(isLine(line));
  EXPECT_FALSE(isLine(ConvexOutline({{3, 1}, {1, 3}, {2, 2 + 1e-5}})));
}

TEST(ConvexOutlines, OfPointsInLineHaveTwoCornersHoweverTheLineRuns) {
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const double radians = degrees * 0.017453292519943295;
    Points points;
    for (int i = 0; i <= 20; ++i)
      points.push_back(Vec2{100, 70} + (i / 20.0) * Vec2{std::cos(radians), std::sin(radians)});
    const ConvexOutline line(points);
    ASSERT_TRUE(isLine(line)) << degrees;
    EXPECT_NEAR(length(line.corners()[1] - line.corners()[0]), 1, 1e-12);
  }
}

TEST(ConvexOutlines, AreConvexAndHoldAllTheirPoints) {
  RandomPoints random;
  for (int i = 0; i < 400; ++i) {
    const std::size_t count = 3 + static_cast<std::size_t>(i % 40);
    const Points points = i % 2 == 0 ? random.points(count) : random.onGrid(count);
    const ConvexOutline outline(points);
    const auto corners = outline.corners();
    if (corners.size() < 4) continue;
    for (std::size_t a = 1; a < corners.size(); ++a) {
      const Vec2 after = corners[a + 1 < corners.size() ? a + 1 : 1];
      EXPECT_LT(orientation(corners[a - 1], corners[a], after), 0);
      for (const Vec2 p : points) EXPECT_LE(orientation(corners[a - 1], corners[a], p), 0);
    }
  }
}

TEST(ConvexOutlines, KnowWhatIsInsideOrNear) {
  RandomPoints random;
  for (int i = 0; i < 400; ++i) {
    const std::size_t count = 1 + static_cast<std::size_t>(i % 40);
    const ConvexOutline outline(i % 2 == 0 ? random.points(count) : random.onGrid(count));
    for (int k = 0; k < 50; ++k) {
      const Vec2 p = k < 40 ? 2 * random.point() : random.onGrid(1)[0];
      const double reach = k % 4 * 0.2;
      EXPECT_EQ(outline.isWithin(p, reach),
                isInside(outline, p) || distanceToEdges(outline, p) < reach);
    }
  }
}

TEST(ConvexOutlines, KnowWhichLinesAreInsideOrNear) {
  RandomPoints random;
  for (int i = 0; i < 400; ++i) {
    const ConvexOutline outline(random.points(1 + static_cast<std::size_t>(i % 20)));
    for (int k = 0; k < 20; ++k) {
      const Vec2 a = 2 * random.point();
      const Vec2 b = 2 * random.point();
      const double reach = 0.01 + k % 4 * 0.2;
      bool isNear = false;
      for (int j = 0; j <= 1000; ++j)
        isNear = isNear || outline.isWithin(lerp(a, b, j / 1000.0), reach);
      if (isNear) {
        EXPECT_TRUE(outline.isWithin(a, b, reach));
      } else {
        EXPECT_FALSE(outline.isWithin(a, b, reach - 0.003)) << "places are looked at every 3 mm";
      }
    }
  }
}

TEST(ConvexOutlines, ShowTheEdgesInAStripAndNotManyMore) {
  Points points;
  for (int i = 0; i < 1000; ++i) points.push_back({std::cos(i * 0.01), std::sin(i * 0.01)});
  const ConvexOutline outline(points);
  for (const double xLow : {-2.0, -1.0, -0.3, 0.0, 0.99, 1.5}) {
    const double xHigh = xLow + 0.1;
    std::size_t shown = 0;
    outline.anyEdge(xLow, xHigh, [&](Vec2 a, Vec2 b) {
      shown += std::max(a.x, b.x) >= xLow && std::min(a.x, b.x) <= xHigh;
      return false;
    });
    std::size_t expected = 0;
    const auto corners = outline.corners();
    for (std::size_t i = 1; i < corners.size(); ++i)
      expected += std::max(corners[i - 1].x, corners[i].x) >= xLow &&
                  std::min(corners[i - 1].x, corners[i].x) <= xHigh;
    EXPECT_EQ(shown, expected);
    std::size_t tested = 0;
    outline.anyEdge(xLow, xHigh, [&](Vec2, Vec2) { return ++tested == 0; });
    EXPECT_LE(tested, expected + 2);
  }
}

}  // namespace
}  // namespace hearth
