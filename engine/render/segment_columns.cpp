#include "render/segment_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/round_up.h"

namespace hearth {

namespace {

/// If two products differ by more than this fraction, quotients of their factors keep their order,
/// or round to the same number: a thousand times their rounding.
constexpr double kClearly = 1e-12;

/// The first column whose centre is not left of x.
int firstColumnAt(double x, int width) {
  return roundedUp(std::clamp(x - 0.5, 0.0, static_cast<double>(width)));
}

/// The first column of what begins, or the one behind what ends, at a point before the eye.
int firstColumnFrom(const Projection& projection, CameraPoint p, int width) {
  return firstColumnAt(projection.columnOf(p), width);
}

}  // namespace

ColumnRange columnsOf(const Projection& projection, const Segment& segment, int width) {
  const CameraPoint p0 = projection.toCamera(segment.p0);
  const CameraPoint p1 = projection.toCamera(segment.p1);
  // Whether p0 is left of p1, except for rounding: in most cases that is known without a division.
  const double left = p0.lateral * p1.depth;
  const double right = p1.lateral * p0.depth;
  const bool ahead0 = p0.depth > 0;
  const bool ahead1 = p1.depth > 0;
  if (ahead0 && ahead1) {
    if (left - right > kClearly * (std::abs(left) + std::abs(right))) return {0, 0};
    const int begin = firstColumnFrom(projection, p0, width);
    return {begin, std::max(begin, firstColumnFrom(projection, p1, width))};
  }
  if (left >= right) return {0, 0};
  // An end behind the eye is off the screen.
  if (ahead0) return {firstColumnFrom(projection, p0, width), width};
  if (ahead1) return {0, firstColumnFrom(projection, p1, width)};
  return {0, 0};
}

SegmentMeetings::SegmentMeetings(const Projection& projection, const Segment& segment)
    : swapped_(lessXY(segment.p1, segment.p0)),
      a_(projection.toCamera(swapped_ ? segment.p1 : segment.p0)),
      b_(projection.toCamera(swapped_ ? segment.p0 : segment.p1)) {}

SegmentMeetings::Meeting SegmentMeetings::at(double slant) const {
  const double sideA = a_.lateral - slant * a_.depth;
  const double sideB = b_.lateral - slant * b_.depth;
  const double along = std::clamp(sideA / (sideA - sideB), 0.0, 1.0);
  const double depth = std::lerp(a_.depth, b_.depth, along);
  // A ray never meets a wall behind the eye; only rounding can say so.
  return {std::max(depth, std::numeric_limits<double>::min()), swapped_ ? 1 - along : along};
}

}  // namespace hearth
