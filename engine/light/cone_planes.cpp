#include "light/cone_planes.h"

#include <algorithm>
#include <cmath>

#include "light/ray_rounding.h"
#include "math/predicates.h"

namespace hearth {

namespace {

/// Whether one plane bounds nothing that the other does not, all over the cone.
bool isHidden(const HeightPlane& plane, const HeightPlane& by, const LightCone& cone) {
  if (plane.isBelow != by.isBelow) return false;
  if (plane.gradient == by.gradient) return plane.slackPerMetre <= by.slackPerMetre;
  const Vec2 further = (plane.isBelow ? 1 : -1) * (by.gradient - plane.gradient);
  const double least = plane.slackPerMetre + by.slackPerMetre;
  return dot(further, cone.begin) >= least && dot(further, cone.end) >= least;
}

}  // namespace

double distanceToLine(Vec3 light, const Segment& wall, Vec2 way) {
  const Vec2 along = wall.p1 - wall.p0;
  return cross(wall.p0 - light.xy(), along) / cross(way, along);
}

double distanceToWall(Vec3 light, const LightCone& cone, const Segment& wall) {
  return length(nearestOnSegment(distanceToLine(light, wall, cone.begin) * cone.begin,
                                 distanceToLine(light, wall, cone.end) * cone.end, {0, 0}));
}

void ConePlanes::add(const LightCone& cone, const Segment& wall, const Edge& edge) {
  const Vec2 a = wall.p0 - light_.xy();
  const Vec2 b = wall.p1 - light_.xy();
  const double h0 = edge.z0 - light_.z;
  const double h1 = edge.z1 - light_.z;
  const Vec2 gradient = (1 / cross(a, b)) * Vec2{h0 * b.y - h1 * a.y, h1 * a.x - h0 * b.x};
  const double size = std::max(
      {largestCoordinate(light_), std::abs(edge.z0), std::abs(edge.z1), length(a), length(b)});
  const double slack = rayMargin(roundingOf(size)) / distanceToWall(light_, cone, wall);
  const HeightPlane plane{gradient, edge.isBelow, slack + roundingOf(length(gradient))};
  for (const HeightPlane& other : planes_)
    if (isHidden(plane, other, cone)) return;
  std::erase_if(planes_, [&](const HeightPlane& other) { return isHidden(other, plane, cone); });
  planes_.push_back(plane);
}

bool ConePlanes::leaveNothingOf(const LightCone& cone) const {
  for (const HeightPlane& low : planes_)
    for (const HeightPlane& high : planes_) {
      if (!low.isBelow || high.isBelow) continue;
      const Vec2 room = high.gradient - low.gradient;
      const double most = -low.slackPerMetre - high.slackPerMetre;
      if (dot(room, cone.begin) < most && dot(room, cone.end) < most) return true;
    }
  return false;
}

}  // namespace hearth
