#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/tolerance.h"
#include "math/vec.h"

/// How far rounding moves rays of light. Within these bounds shafts and beams give no answer.
namespace hearth {

inline double largestCoordinate(Vec3 p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// Metres by which rounding moves a target or a crossing at most, with coordinates up to `size`
/// metres.
inline double roundingOf(double size) { return 64 * std::numeric_limits<double>::epsilon() * size; }

/// Metres within which a bound decides nothing: rays may be off by `rounding`, and nothing stops
/// them at their end.
inline double rayMargin(double rounding) { return 2 * kArrival + rounding; }

/// Metres that a light must be in front of a plane, so that the plane stops rays of `reach` metres
/// to its points no farther from these than kArrival.
inline double minInFront(double rounding, double reach) { return 4 * rounding * reach / kArrival; }

}  // namespace hearth
