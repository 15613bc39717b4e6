#include "import/doom/snap_rounding.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace hearth::doom {

namespace {

std::int64_t cross(GridPoint origin, GridPoint a, GridPoint b) {
  return std::int64_t{a.x - origin.x} * (b.y - origin.y) -
         std::int64_t{a.y - origin.y} * (b.x - origin.x);
}

int signOf(std::int64_t n) { return n > 0 ? 1 : n < 0 ? -1 : 0; }

/// The nearest whole number to p / q; of two, the larger one.
std::int64_t rounded(std::int64_t p, std::int64_t q) {
  if (q < 0) p = -p, q = -q;
  const std::int64_t n = 2 * p + q;
  return n / (2 * q) - (n % (2 * q) < 0 ? 1 : 0);
}

/// Whether a segment passes the square of one cell round a point, which none of its ends is. To the
/// square belong its least x and y, as `rounded` has it: it is thought moved by (-e, -e * e), e
/// being less than any number, so that no segment meets its border only.
bool passes(GridPoint from, GridPoint to, GridPoint p) {
  const auto [minX, maxX] = std::minmax(from.x, to.x);
  const auto [minY, maxY] = std::minmax(from.y, to.y);
  if (p.x < minX || p.x > maxX || p.y < minY || p.y > maxY) return false;
  const std::int64_t dx = std::int64_t{to.x} - from.x;
  const std::int64_t dy = std::int64_t{to.y} - from.y;
  const std::int64_t middle = 2 * cross(from, to, p);  // of doubled places, whose corners are whole
  const int sideOfMove = dy != 0 ? signOf(dy) : -signOf(dx);
  int sides = 0;
  for (const int x : {-1, 1})
    for (const int y : {-1, 1}) {
      const std::int64_t corner = middle + dx * y - dy * x;
      sides += corner == 0 ? sideOfMove : signOf(corner);
    }
  return std::abs(sides) != 4;
}

}  // namespace

std::optional<GridPoint> crossingOf(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  if (signOf(cross(a, b, c)) * signOf(cross(a, b, d)) >= 0) return std::nullopt;
  const std::int64_t fromA = cross(c, d, a);
  const std::int64_t fromB = cross(c, d, b);
  if (signOf(fromA) * signOf(fromB) >= 0) return std::nullopt;
  return GridPoint{static_cast<int>(a.x + rounded((b.x - a.x) * fromA, fromA - fromB)),
                   static_cast<int>(a.y + rounded((b.y - a.y) * fromA, fromA - fromB))};
}

SnapRounding::SnapRounding(std::vector<GridPoint> hot) : hot_(std::move(hot)) {
  std::ranges::sort(hot_);
  hot_.erase(std::unique(hot_.begin(), hot_.end()), hot_.end());
}

/// Ends: what leads to a point lies in a box that shrinks.
std::vector<GridPoint> SnapRounding::pathOf(GridPoint from, GridPoint to) const {
  std::vector<GridPoint> path{from};
  std::vector<GridPoint> ahead{to};  // the next one last
  while (!ahead.empty()) {
    const std::vector<GridPoint> passed = passedOnTheWay(path.back(), ahead.back());
    if (passed.empty()) {
      path.push_back(ahead.back());
      ahead.pop_back();
    }
    ahead.insert(ahead.end(), passed.rbegin(), passed.rend());
  }
  return path;
}

std::vector<GridPoint> SnapRounding::passedOnTheWay(GridPoint from, GridPoint to) const {
  std::vector<GridPoint> passed;
  const auto [minX, maxX] = std::minmax(from.x, to.x);
  const auto [minY, maxY] = std::minmax(from.y, to.y);
  const auto end = std::ranges::upper_bound(hot_, GridPoint{maxX, maxY});
  for (auto p = std::ranges::lower_bound(hot_, GridPoint{minX, minY}); p < end; ++p)
    if (*p != from && *p != to && passes(from, to, *p)) passed.push_back(*p);
  std::ranges::sort(passed, {},
                    [&](GridPoint p) { return std::abs(p.x - from.x) + std::abs(p.y - from.y); });
  return passed;
}

}  // namespace hearth::doom
