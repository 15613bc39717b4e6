#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/line_part.h"
#include "math/vec.h"

namespace hearth {

/// The part of the line a -> b inside a picture of this size, in pixels.
inline std::optional<LinePart> insidePicture(Vec2 a, Vec2 b, int width, int height) {
  std::optional<LinePart> part = keepPositive({}, a.x, b.x);
  if (part) part = keepPositive(*part, width - a.x, width - b.x);
  if (part) part = keepPositive(*part, a.y, b.y);
  if (part) part = keepPositive(*part, height - a.y, height - b.y);
  return part;
}

/// Calls `plot(x, y, fraction)` for pixels along the line a -> b inside a picture of this size, one
/// for each column or for each row, whichever are more. `fraction` is of the way from a to b.
template <typename Plot>
void forEachPixelOfLine(Vec2 a, Vec2 b, int width, int height, Plot&& plot) {
  const std::optional<LinePart> part = insidePicture(a, b, width, height);
  if (!part) return;
  const Vec2 start = lerp(a, b, part->from);
  const Vec2 end = lerp(a, b, part->to);
  // Both ends are inside except for rounding, which the clamps take care of.
  const double longest = std::max(std::abs(end.x - start.x), std::abs(end.y - start.y));
  const int steps = static_cast<int>(std::min<double>(std::ceil(longest), width + height));
  for (int i = 0; i <= steps; ++i) {
    const double fraction = steps == 0 ? 0 : static_cast<double>(i) / steps;
    const Vec2 p = lerp(start, end, fraction);
    const int x = static_cast<int>(std::clamp(p.x, 0.0, width - 1.0));
    const int y = static_cast<int>(std::clamp(p.y, 0.0, height - 1.0));
    plot(x, y, std::lerp(part->from, part->to, fraction));
  }
}

}  // namespace hearth
