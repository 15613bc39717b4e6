#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace hearth {

/// A part of a line, as fractions of the way from its first end to its second.
struct LinePart {
  double from = 0;
  double to = 1;
};

/// Cuts off `part` where a linear function along the line, from `first` to `second`, is negative
/// (Liang and Barsky, 1984). None if no part is left, or if the change is beyond the range of
/// double.
inline std::optional<LinePart> keepPositive(LinePart part, double first, double second) {
  if (!std::isfinite(first - second)) return std::nullopt;
  if (first < 0 && second < 0) return std::nullopt;
  if (first < 0) part.from = std::max(part.from, first / (first - second));
  if (second < 0) part.to = std::min(part.to, first / (first - second));
  if (!(part.from <= part.to)) return std::nullopt;
  return part;
}

}  // namespace hearth
