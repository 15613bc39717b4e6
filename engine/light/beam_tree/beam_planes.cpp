#include "light/beam_tree/beam_planes.h"

#include <algorithm>
#include <cmath>

#include "light/ray_error.h"
#include "math/predicates.h"

namespace hearth {

namespace {

/// Whether one plane bounds nothing that the other does not, all over the beam.
bool isHidden(const HeightPlane& plane, const HeightPlane& by, const Beam& beam) {
  if (plane.isBelow != by.isBelow) return false;
  if (plane.gradient == by.gradient) return plane.slackPerMetre <= by.slackPerMetre;
  const Vec2 further = (plane.isBelow ? 1 : -1) * (by.gradient - plane.gradient);
  const double least = plane.slackPerMetre + by.slackPerMetre;
  return dot(further, beam.begin) >= least && dot(further, beam.end) >= least;
}

}  // namespace

double distanceToLine(Vec3 light, const Segment& wall, Vec2 direction) {
  const Vec2 along = wall.p1 - wall.p0;
  return cross(wall.p0 - light.xy(), along) / cross(direction, along);
}

double distanceToWall(Vec3 light, const Beam& beam, const Segment& wall) {
  return length(nearestOnSegment(distanceToLine(light, wall, beam.begin) * beam.begin,
                                 distanceToLine(light, wall, beam.end) * beam.end, {0, 0}));
}

void BeamPlanes::add(const Beam& beam, const Segment& wall, const Edge& edge) {
  const Vec2 a = wall.p0 - light_.xy();
  const Vec2 b = wall.p1 - light_.xy();
  const double h0 = edge.z0 - light_.z;
  const double h1 = edge.z1 - light_.z;
  const Vec2 gradient = (1 / cross(a, b)) * Vec2{h0 * b.y - h1 * a.y, h1 * a.x - h0 * b.x};
  const double size = std::max(
      {largestCoordinate(light_), std::abs(edge.z0), std::abs(edge.z1), length(a), length(b)});
  const double slack = rayMargin(roundingOf(size)) / distanceToWall(light_, beam, wall);
  const HeightPlane plane{gradient, edge.isBelow, slack + roundingOf(length(gradient))};
  for (const HeightPlane& other : planes_)
    if (isHidden(plane, other, beam)) return;
  std::erase_if(planes_, [&](const HeightPlane& other) { return isHidden(other, plane, beam); });
  planes_.push_back(plane);
}

bool BeamPlanes::leaveNothingOf(const Beam& beam) const {
  for (const HeightPlane& low : planes_)
    for (const HeightPlane& high : planes_) {
      if (!low.isBelow || high.isBelow) continue;
      const Vec2 room = high.gradient - low.gradient;
      const double most = -low.slackPerMetre - high.slackPerMetre;
      if (dot(room, beam.begin) < most && dot(room, beam.end) < most) return true;
    }
  return false;
}

}  // namespace hearth
