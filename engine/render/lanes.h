#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "render/strip.h"

/// The columns of a strip side by side. A lane is one of these columns, as in a vector register.
namespace hearth {

/// A number for each lane.
struct alignas(64) LaneDoubles : std::array<double, Strip::kColumns> {};

/// A row for each lane.
struct alignas(32) LaneRows : std::array<std::int32_t, Strip::kColumns> {};

/// Some lanes: bit i is set for the i-th.
using LaneSet = std::uint8_t;
inline constexpr LaneSet kAllLanes = 0xFF;

/// Those for which `is(lane)`.
template <typename Is>
LaneSet lanesWhere(Is&& is) {
  unsigned set = 0;
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane) set |= (is(lane) ? 1U : 0U) << lane;
  return static_cast<LaneSet>(set);
}

/// Sets some lanes of one to those of another.
inline void setLanes(LaneDoubles& to, const LaneDoubles& from, LaneSet lanes) {
  if (lanes == kAllLanes)
    to = from;
  else
    for (unsigned rest = lanes; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
      to[lane] = from[lane];
    }
}

/// Rows [begin, end) of each lane. A lane may have none.
struct LaneRowRanges {
  LaneRows begin{};
  LaneRows end{};

  bool has(std::size_t lane) const { return begin[lane] < end[lane]; }

  /// Those that have rows.
  LaneSet lanes() const {
    return lanesWhere([this](std::size_t lane) { return has(lane); });
  }

  /// The number of lanes that have rows.
  int laneCount() const {
    int count = 0;
    for (std::size_t lane = 0; lane < begin.size(); ++lane) count += has(lane) ? 1 : 0;
    return count;
  }

  /// The number of rows of all lanes.
  int rowCount() const {
    int count = 0;
    for (std::size_t lane = 0; lane < begin.size(); ++lane)
      count += std::max(0, end[lane] - begin[lane]);
    return count;
  }
};

}  // namespace hearth
