#include "light/light_cones.h"

#include <algorithm>
#include <cmath>

#include "light/light_cone_finder.h"
#include "light/ray_rounding.h"
#include "light/target_air.h"
#include "math/tolerance.h"

namespace hearth {

LightCones::LightCones(const Level& level, const Raytracer::Source& light, double reach,
                       std::size_t mostBytes)
    : level_(level), light_(light), found_(findLightCones(level, light, reach, mostBytes)) {
  for (std::size_t i = 0; i < found_.cones.size(); ++i)
    ++rangeOf_.try_emplace(found_.cones[i].sector.value, Range{i, 0}).first->second.count;
}

LightCones::Points LightCones::seen(std::span<const Vec3> corners) const {
  Points points;
  points.corners = corners;
  for (const Vec3 p : corners) {
    const Vec3 way = p - light_.position;
    points.ways[points.count++] = way;
    points.reach = std::max(points.reach, std::abs(way.x) + std::abs(way.y) + std::abs(way.z));
  }
  points.noise = roundingOf(largestCoordinate(light_.position) + points.reach);
  points.margin = rayMargin(points.noise) + kNarrow * points.reach;
  return points;
}

bool LightCones::knows(SectorId sector, const Plane& plane, const Points& points) const {
  return found_.isComplete && !found_.unknown.contains(sector.value) &&
         plane.inFront(light_.position) >= leastInFront(points.noise, points.reach) &&
         isAirClear(level_[sector], {light_.position, 0, points.reach, points.noise, points.margin},
                    points.corners);
}

/// None where the cone holds none of the points.
std::optional<LightCones::Doubt> LightCones::doubtOf(const LightCone& cone, const Points& points,
                                                     const Segment* on) const {
  const auto isBounded = [&](double slack, bool& isDoubtful, auto&& inFront) {
    double least = inFront(points.ways[0]);
    double most = least;
    for (std::size_t i = 1; i < points.count; ++i) {
      const double distance = inFront(points.ways[i]);
      least = std::min(least, distance);
      most = std::max(most, distance);
    }
    isDoubtful |= least <= slack;
    return most >= -slack;
  };
  Doubt doubt{&cone, false, false, cone.isDoubtful};
  if (!isBounded(points.margin, doubt.atBegin,
                 [&](Vec3 way) { return cross(cone.begin, way.xy()); }) ||
      !isBounded(points.margin, doubt.atEnd, [&](Vec3 way) { return cross(way.xy(), cone.end); }))
    return std::nullopt;
  const auto isBoundedBy = [&](const Segment* wall) {
    const Vec2 along = wall->p1 - wall->p0;
    const Vec2 start = wall->p0 - light_.position.xy();
    return isBounded(points.margin * wall->length, doubt.elsewhere,
                     [&](Vec3 way) { return cross(along, way.xy() - start); });
  };
  if (!on || cone.to != on) {
    if (cone.from && !isBoundedBy(cone.from)) return std::nullopt;
    if (cone.to && !isBoundedBy(cone.to)) return std::nullopt;
  }
  for (const HeightPlane& plane : found_.planesOf(cone)) {
    const double sign = plane.isBelow ? 1 : -1;
    if (!isBounded(points.margin + plane.slackPerMetre * points.reach, doubt.elsewhere,
                   [&](Vec3 way) { return sign * (way.z - dot(plane.gradient, way.xy())); }))
      return std::nullopt;
  }
  return doubt;
}

/// Whether points lie in a cone for sure; if they may, adds it.
bool LightCones::add(const LightCone& cone, const Points& points, const Segment* on,
                     Found& found) const {
  const std::optional<Doubt> doubt = doubtOf(cone, points, on);
  if (!doubt) return false;
  if (!doubt->atBegin && !doubt->atEnd && !doubt->elsewhere) return true;
  found.push_back(*doubt);
  return false;
}

/// Whether cones, each of which begins at the very vertex where another ends, hold all that lies
/// between the begin of the first and the end of the last: on whichever side of the vertex a ray
/// passes, one of the two lights what it goes to.
bool LightCones::isRow(std::span<const Doubt> doubts) {
  if (std::ranges::any_of(doubts, &Doubt::elsewhere)) return false;
  const auto first = std::ranges::find(doubts, false, &Doubt::atBegin);
  if (first == doubts.end()) return false;
  const Doubt* last = &*first;
  for (std::size_t steps = 0; last->atEnd; ++steps) {
    const auto next = std::ranges::find(doubts, last->cone->endsAt,
                                        [](const Doubt& doubt) { return doubt.cone->beginsAt; });
    if (next == doubts.end() || steps == doubts.size()) return false;
    last = &*next;
  }
  return true;
}

/// Whether points on a wall may lie on its end, and so on the next wall, too.
bool LightCones::comesToEndOf(const Segment& wall, const Points& points) const {
  const Vec2 along = wall.p1 - wall.p0;
  const Vec2 start = wall.p0 - light_.position.xy();
  const double margin = points.margin * wall.length;
  return std::ranges::any_of(std::span(points.ways).first(points.count), [&](Vec3 way) {
    const double share = dot(along, way.xy() - start);
    return share < margin || share > wall.length * wall.length - margin;
  });
}

bool LightCones::find(SectorId sector, const Segment* on, const Points& points,
                      Found& found) const {
  const std::size_t before = found.size();
  const auto range = rangeOf_.find(sector.value);
  if (range == rangeOf_.end()) return false;
  const auto ofSector = std::span(found_.cones).subspan(range->second.first, range->second.count);
  const auto holds = [&](const LightCone& cone) { return add(cone, points, on, found); };
  const auto isAnyTo = [&](const Segment* wall) {
    return std::any_of(std::ranges::lower_bound(ofSector, wall, {}, &LightCone::to),
                       std::ranges::upper_bound(ofSector, wall, {}, &LightCone::to), holds);
  };
  const bool isLit = !on || comesToEndOf(*on, points) ? std::ranges::any_of(ofSector, holds)
                                                      : isAnyTo(nullptr) || isAnyTo(on);
  return isLit || isRow(std::span(found).subspan(before));
}

bool LightCones::narrow(const Points& points, const Segment* on, Found& found, std::size_t first,
                        std::size_t last) const {
  const std::size_t before = found.size();
  for (std::size_t i = first; i < last; ++i)
    if (add(*found[i].cone, points, on, found)) return true;
  return isRow(std::span(found).subspan(before));
}

}  // namespace hearth
