#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

#include "math/vec.h"

namespace hearth {

/// The slope of straight up; straight down has the opposite.
inline constexpr double kStraightUp = std::numeric_limits<double>::infinity();

/// Directions of one compass direction, by their slopes: metres up for each metre along the map.
struct SlopeRange {
  double from;
  double to;

  bool isEmpty() const { return !(from < to); }
};

inline SlopeRange common(SlopeRange a, SlopeRange b) {
  return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

/// Those before a plane; `ahead` is the part of its normal in their compass direction.
inline SlopeRange slopesBefore(Vec3 normal, double ahead) {
  if (normal.z == 0) return ahead > 0 ? SlopeRange{-kStraightUp, kStraightUp} : SlopeRange{0, 0};
  const double inPlane = -ahead / normal.z;
  return normal.z > 0 ? SlopeRange{inPlane, kStraightUp} : SlopeRange{-kStraightUp, inPlane};
}

/// Calls `visit` for what ranges leave of one, from below. They are those of `blocked`, rising,
/// apart from one another; `rangeOf` is a member or a function that tells that of an element.
template <typename Blocked, typename RangeOf, typename Visit>
void forEachFree(const Blocked& blocked, RangeOf&& rangeOf, SlopeRange all, Visit&& visit) {
  for (const auto& element : blocked) {
    const SlopeRange range = std::invoke(rangeOf, element);
    if (const SlopeRange free = common(all, {all.from, range.from}); !free.isEmpty()) visit(free);
    all.from = std::max(all.from, range.to);
  }
  if (!all.isEmpty()) visit(all);
}

/// Slopes whose lines something stops.
class BlockedSlopes {
 public:
  void clear() { ranges_.clear(); }

  void add(SlopeRange range) {
    if (range.isEmpty()) return;
    // Those that it touches become one with it.
    const auto first = std::ranges::lower_bound(ranges_, range.from, {}, &SlopeRange::to);
    const auto end =
        std::ranges::upper_bound(first, ranges_.end(), range.to, {}, &SlopeRange::from);
    if (first == end) {
      ranges_.insert(first, range);
      return;
    }
    *first = {std::min(first->from, range.from), std::max(std::prev(end)->to, range.to)};
    ranges_.erase(std::next(first), end);
  }

  /// Calls `visit` for what these leave of a range, from below.
  template <typename Visit>
  void forEachFree(SlopeRange all, Visit&& visit) const {
    hearth::forEachFree(ranges_, std::identity(), all, visit);
  }

 private:
  std::vector<SlopeRange> ranges_;  ///< rising, apart from one another
};

}  // namespace hearth
