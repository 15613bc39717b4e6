#include "import/doom/snap_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "math/predicates.h"
#include "random_levels/random.h"

namespace hearth::doom {

namespace {

struct Segment {
  GridPoint from;
  GridPoint to;
  friend auto operator<=>(Segment, Segment) = default;
};

Vec2 placeOf(GridPoint p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// Segments through one another, many of them nearly through one point.
std::vector<Segment> tangle(random_levels::Random& random) {
  const int size = random.pick({9, 60, 5000, 131'000});
  const auto whole = [&](int most) { return static_cast<int>(random.between(-most, most)); };
  std::vector<Segment> segments;
  for (std::int64_t i = random.between(2, 25); i > 0; --i) {
    const GridPoint from{whole(size), whole(size)};
    const GridPoint to = random.chance(0.5) ? GridPoint{whole(size), whole(size)}
                                            : GridPoint{whole(9) - from.x, whole(9) - from.y};
    if (from != to) segments.push_back({from, to});
  }
  return segments;
}

SnapRounding roundingOf(const std::vector<Segment>& segments) {
  std::vector<GridPoint> hot;
  for (const Segment& a : segments) {
    hot.push_back(a.from);
    hot.push_back(a.to);
    for (const Segment& b : segments)
      if (const auto p = crossingOf(a.from, a.to, b.from, b.to)) hot.push_back(*p);
  }
  return SnapRounding(std::move(hot));
}

/// What segments become, each piece once and from its smaller end.
std::set<Segment> piecesOf(const std::vector<Segment>& segments) {
  const SnapRounding rounding = roundingOf(segments);
  std::set<Segment> pieces;
  for (const Segment& segment : segments) {
    const auto path = rounding.pathOf(segment.from, segment.to);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      pieces.insert({std::min(path[i], path[i + 1]), std::max(path[i], path[i + 1])});
  }
  return pieces;
}

TEST(CrossingOfSegments, isRoundedToTheGridAndOfTwoPointsTheLarger) {
  EXPECT_EQ(crossingOf({0, 0}, {4, 4}, {0, 4}, {4, 0}), (GridPoint{2, 2}));
  EXPECT_EQ(crossingOf({0, 0}, {3, 3}, {0, 3}, {3, 0}), (GridPoint{2, 2}));
  EXPECT_EQ(crossingOf({0, 0}, {-3, -3}, {0, -3}, {-3, 0}), (GridPoint{-1, -1}));
}

TEST(CrossingOfSegments, isNoneWhereOneEndsOnTheOther) {
  EXPECT_EQ(crossingOf({0, 0}, {4, 4}, {2, 2}, {4, 0}), std::nullopt);
  EXPECT_EQ(crossingOf({0, 0}, {4, 4}, {3, 2}, {4, 0}), std::nullopt);
}

TEST(PathOfASegment, leadsThroughThePointsWhoseSquaresItPasses) {
  const SnapRounding rounding({{0, 0}, {10, 1}, {5, 0}, {5, 1}, {8, 2}, {3, 3}});
  // At x = 5 it lies between two squares: the upper border belongs to the larger one.
  EXPECT_EQ(rounding.pathOf({0, 0}, {10, 1}),
            (std::vector<GridPoint>{{0, 0}, {5, 0}, {5, 1}, {10, 1}}));
}

TEST(PathsOfSegments, neitherCrossNorComeNearerToAPointThanHalfACell) {
  random_levels::Random random{7};
  for (int i = 0; i < 500; ++i) {
    const std::set<Segment> pieces = piecesOf(tangle(random));
    for (const Segment& a : pieces)
      for (const Segment& b : pieces) {
        ASSERT_EQ(crossingOf(a.from, a.to, b.from, b.to), std::nullopt) << "tangle " << i;
        for (const GridPoint p : {b.from, b.to}) {
          if (p == a.from || p == a.to) continue;
          const Vec2 nearest = nearestOnSegment(placeOf(a.from), placeOf(a.to), placeOf(p));
          ASSERT_GE(length(nearest - placeOf(p)), 0.5 - 1e-9) << "tangle " << i;
        }
      }
  }
}

}  // namespace

}  // namespace hearth::doom
