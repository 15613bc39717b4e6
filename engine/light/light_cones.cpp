#include "light/light_cones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

/// Calls visit(bound, side) for each bound of a cone until that says no: whether it never does.
template <typename Visit>
bool LightCones::visitBounds(const LightCone& cone, const Points& points, const Segment* on,
                             Visit&& visit) const {
  const auto [begin, end] = std::pair(cone.begin, cone.end);
  if (!visit(WayBound{{-begin.y, begin.x, 0}, 0, points.margin}, Side::Begin)) return false;
  if (!visit(WayBound{{end.y, -end.x, 0}, 0, points.margin}, Side::End)) return false;
  const auto isWithin = [&](const Segment* wall) {
    const Vec2 along = wall->p1 - wall->p0;
    const Vec2 start = wall->p0 - light_.position.xy();
    return visit(
        WayBound{{-along.y, along.x, 0}, cross(along, start), points.margin * wall->length},
        Side::Elsewhere);
  };
  if (!on || cone.to != on) {
    if (cone.from && !isWithin(cone.from)) return false;
    if (cone.to && !isWithin(cone.to)) return false;
  }
  return std::ranges::all_of(found_.planesOf(cone), [&](const HeightPlane& plane) {
    const double sign = plane.isBelow ? 1 : -1;
    const Vec3 normal{-sign * plane.gradient.x, -sign * plane.gradient.y, sign};
    return visit(WayBound{normal, 0, points.margin + plane.slackPerMetre * points.reach},
                 Side::Elsewhere);
  });
}

namespace {

struct Distances {
  double least;
  double most;
};

Distances inFrontOf(const WayBound& bound, const LightCones::Points& points) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t i = 0; i < points.count; ++i) {
    const double distance = dot(bound.normal, points.ways[i]) - bound.offset;
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  return {least, most};
}

}  // namespace

/// None where the cone holds none of the points.
std::optional<LightCones::Doubt> LightCones::doubtOf(const LightCone& cone, const Points& points,
                                                     const Segment* on) const {
  Doubt doubt{&cone, false, false, cone.isDoubtful};
  const bool isNear = visitBounds(cone, points, on, [&](const WayBound& bound, Side side) {
    const Distances distances = inFrontOf(bound, points);
    if (distances.least <= bound.slack)
      (side == Side::Begin ? doubt.atBegin
       : side == Side::End ? doubt.atEnd
                           : doubt.elsewhere) = true;
    return distances.most >= -bound.slack;
  });
  return isNear ? std::optional(doubt) : std::nullopt;
}

void LightCones::findSeen(const Points& points, const Segment* on, std::span<const Doubt> doubts,
                          const Samples& samples, double* seen) const {
  std::vector<WayBound> parting;
  std::vector<PartingBounds> cones;
  for (const Doubt& doubt : doubts) {
    const std::size_t before = parting.size();
    visitBounds(*doubt.cone, points, on, [&](const WayBound& bound, Side) {
      if (inFrontOf(bound, points).least <= bound.slack) parting.push_back(bound);
      return true;
    });
    cones.push_back({parting.size() - before, doubt.cone->isDoubtful});
  }
  for (std::size_t row = 0; row < samples.rows; ++row)
    lightKernels().findSeen(samples.arrays.from(row * samples.stride), samples.columns,
                            light_.position, cones, parting.data(), seen + row * samples.stride);
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
