#pragma once

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

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

  bool covers(SlopeRange range) const {
    const auto at = std::ranges::lower_bound(ranges_, range.to, {}, &SlopeRange::to);
    return at != ranges_.end() && at->from <= range.from;
  }

  /// Calls `visit` for what these leave of a range, from below.
  template <typename Visit>
  void forEachFree(SlopeRange all, Visit&& visit) const {
    for (const SlopeRange range : ranges_) {
      if (const SlopeRange free = common(all, {all.from, range.from}); !free.isEmpty()) visit(free);
      all.from = std::max(all.from, range.to);
    }
    if (!all.isEmpty()) visit(all);
  }

 private:
  std::vector<SlopeRange> ranges_;  ///< rising, apart from one another
};

}  // namespace hearth
