#include "level/convex_outline.h"

#include <cmath>
#include <utility>

#include "math/check.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Exact, by monotone chains (A. M. Andrew, "Another efficient algorithm for convex hulls in two
/// dimensions", 1979). In the order of ConvexOutline::corners.
std::vector<Vec2> convexHull(std::vector<Vec2> points) {
  std::ranges::sort(points, lessXY);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Vec2> hull{points.front()};
  const auto extend = [&](Vec2 p, std::size_t kept) {
    while (hull.size() > kept && orientation(hull[hull.size() - 2], hull.back(), p) >= 0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (std::size_t i = 1; i < points.size(); ++i) extend(points[i], 1);
  const std::size_t there = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) extend(points[i], there);
  return hull;
}

Vec2 farthestFrom(Vec2 p, std::span<const Vec2> corners) {
  return *std::ranges::max_element(corners, {}, [&](Vec2 corner) { return length(corner - p); });
}

bool haveNoBreadth(std::span<const Vec2> corners, Vec2 from, Vec2 to) {
  const double slack = kPositionSlack * length(to - from);
  return std::ranges::all_of(corners,
                             [&](Vec2 p) { return std::abs(cross(to - from, p - from)) <= slack; });
}

/// What is left of a hull without breadth. So no corner is so sharp that rounding decides on which
/// sides of its edges a place before it lies.
std::vector<Vec2> withoutSlivers(std::vector<Vec2> hull) {
  Vec2 from = farthestFrom(hull.front(), hull);
  Vec2 to = farthestFrom(from, hull);
  if (length(to - from) <= kPositionSlack) return {from};
  if (!haveNoBreadth(hull, from, to)) return hull;
  if (lessXY(to, from)) std::swap(from, to);
  return {from, to, from};
}

bool doCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 &&
         orientation(c, d, a) * orientation(c, d, b) < 0;
}

bool areNear(Vec2 a, Vec2 b, Vec2 c, Vec2 d, double reach) {
  const auto isNear = [reach](Vec2 from, Vec2 to, Vec2 p) {
    return length(nearestOnSegment(from, to, p) - p) < reach;
  };
  return isNear(a, b, c) || isNear(a, b, d) || isNear(c, d, a) || isNear(c, d, b) ||
         doCross(a, b, c, d);
}

}  // namespace

ConvexOutline::ConvexOutline(std::vector<Vec2> points) {
  CHECK(!points.empty());
  corners_ = withoutSlivers(convexHull(std::move(points)));
  for (const Vec2 corner : corners_) box_.add(corner);
  const auto rightmost = std::ranges::max_element(corners_, lessXY);
  turn_ = static_cast<std::size_t>(rightmost - corners_.begin());
}

/// Strictly inside.
bool ConvexOutline::covers(Vec2 p) const {
  return box_.contains(p) &&
         !anyEdge(p.x, p.x, [&](Vec2 a, Vec2 b) { return orientation(a, b, p) >= 0; });
}

bool ConvexOutline::isWithin(Vec2 p, double reach) const {
  if (!grown(box_, reach).contains(p)) return false;
  return covers(p) || anyEdge(p.x - reach, p.x + reach, [&](Vec2 a, Vec2 b) {
           return length(nearestOnSegment(a, b, p) - p) < reach;
         });
}

bool ConvexOutline::isWithin(Vec2 a, Vec2 b, double reach) const {
  const Box around = grown(boxOf(a, b), reach);
  if (!touch(around, box_)) return false;
  return covers(a) || anyEdge(around.min.x, around.max.x,
                              [&](Vec2 c, Vec2 d) { return areNear(a, b, c, d, reach); });
}

}  // namespace hearth
