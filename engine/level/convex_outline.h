#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "math/box.h"
#include "math/vec.h"

namespace hearth {

/// The outline of a convex part of the map: a polygon, a line or a point.
class ConvexOutline {
 public:
  /// The convex hull of points, of which there is at least one. If it is nowhere wider than
  /// kPositionSlack it becomes a line, and a point if it is no longer either.
  explicit ConvexOutline(std::vector<Vec2> points);

  const Box& box() const { return box_; }

  /// From the leftmost, counter-clockwise on the map: the outside is in front of each edge. The
  /// first one again at the end, if there are others.
  std::span<const Vec2> corners() const { return corners_; }

  /// Whether `p` is inside, or nearer to the outline than `reach`.
  bool isWithin(Vec2 p, double reach) const;

  /// Whether a part of the segment from a to b is.
  bool isWithin(Vec2 a, Vec2 b, double reach) const;

  /// Whether `test(a, b)` holds for one of the edges, from a to b, that have a part in
  /// xLow <= x <= xHigh. Others cost little. A point is an edge from itself to itself, and always
  /// tested.
  template <typename Test>
  bool anyEdge(double xLow, double xHigh, Test&& test) const {
    if (corners_.size() == 1) return test(corners_[0], corners_[0]);
    return anyEdgeOf(corners().first(turn_ + 1), 1, xLow, xHigh, test) ||
           anyEdgeOf(corners().subspan(turn_), -1, -xHigh, -xLow, test);
  }

 private:
  bool covers(Vec2 p) const;

  /// Of a part of the outline along which `sign` * x never falls.
  template <typename Test>
  static bool anyEdgeOf(std::span<const Vec2> chain, double sign, double low, double high,
                        Test& test) {
    const auto entered =
        std::ranges::partition_point(chain, [&](Vec2 corner) { return sign * corner.x < low; });
    auto i = static_cast<std::size_t>(entered - chain.begin());
    if (i > 0) --i;
    for (; i + 1 < chain.size() && sign * chain[i].x <= high; ++i)
      if (test(chain[i], chain[i + 1])) return true;
    return false;
  }

  std::vector<Vec2> corners_;
  std::size_t turn_ = 0;  // index of the rightmost
  Box box_;
};

}  // namespace hearth
