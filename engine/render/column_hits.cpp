#include "render/column_hits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/planted_bug.h"

namespace hearth {

namespace {

constexpr double kFarLeft = -std::numeric_limits<double>::infinity();
constexpr double kFarRight = std::numeric_limits<double>::infinity();

/// The first column whose centre is not left of x.
int firstColumnAt(double x, int width) {
  return static_cast<int>(std::ceil(std::clamp(x - 0.5, 0.0, static_cast<double>(width))));
}

/// Ends of what of a segment lies in front of the eye, as columns.
struct Reach {
  double from;
  double to;
};

Reach reachOf(const Projection& projection, CameraPoint p0, CameraPoint p1) {
  const double nearPlane = planted(PlantedBug::NearPlaneAtOneCentimetre) ? 0.01 : 0;
  const bool ahead0 = p0.depth > nearPlane;
  const bool ahead1 = p1.depth > nearPlane;
  if (!ahead0 && !ahead1) return {0, 0};
  // An end behind the eye is off the screen: to the left for p0 and to the right for p1 of a
  // segment whose front the eye sees, the other way round for its back.
  const bool front = p0.lateral * p1.depth < p1.lateral * p0.depth;
  if (!ahead0) return {front ? kFarLeft : kFarRight, projection.columnOf(p1)};
  if (!ahead1) return {projection.columnOf(p0), front ? kFarRight : kFarLeft};
  return {projection.columnOf(p0), projection.columnOf(p1)};
}

}  // namespace

ProjectedSegment::ProjectedSegment(const Projection& projection, const Segment& segment, int width)
    : swapped_(lessXY(segment.p1, segment.p0)) {
  const CameraPoint p0 = projection.toCamera(segment.p0);
  const CameraPoint p1 = projection.toCamera(segment.p1);
  a_ = swapped_ ? p1 : p0;
  b_ = swapped_ ? p0 : p1;
  const Reach reach = reachOf(projection, p0, p1);
  facing_ = reach.from <= reach.to ? Facing::Front : Facing::Back;
  columns_ = {firstColumnAt(std::min(reach.from, reach.to), width),
              firstColumnAt(std::max(reach.from, reach.to), width)};
}

ProjectedSegment::Meeting ProjectedSegment::meet(double slant) const {
  const double sideA = a_.lateral - slant * a_.depth;
  const double sideB = b_.lateral - slant * b_.depth;
  const double along = std::clamp(sideA / (sideA - sideB), 0.0, 1.0);
  const double depth = std::lerp(a_.depth, b_.depth, along);
  // A ray never meets a wall behind the eye; only rounding can say so.
  return {std::max(depth, std::numeric_limits<double>::min()), swapped_ ? 1 - along : along};
}

}  // namespace hearth
