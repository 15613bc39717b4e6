#include "light/light_cones.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "light/light_cone_finder.h"
#include "light/ray_rounding.h"
#include "light/target_air.h"
#include "math/tolerance.h"

namespace hearth {

LightCones::LightCones(const Level& level, const Raytracer::Source& light, double reach,
                       std::size_t mostBytes)
    : level_(level), light_(light), found_(findLightCones(level, light, reach, mostBytes)) {
  const std::vector<LightCone>& cones = found_.cones;
  for (auto* side : {&sides_.beginX, &sides_.beginY, &sides_.endX, &sides_.endY})
    side->reserve(cones.size());
  for (std::size_t i = 0; i < cones.size(); ++i) {
    ++rangeOf_.try_emplace(cones[i].sector.value, Range{i, i}).first->second.last;
    sides_.beginX.push_back(-cones[i].begin.y);
    sides_.beginY.push_back(cones[i].begin.x);
    sides_.endX.push_back(cones[i].end.y);
    sides_.endY.push_back(-cones[i].end.x);
  }
}

ConeBounds LightCones::boundsOf(const LightCone& cone, const Segment* on) const {
  return {cone, found_.planesOf(cone), light_.position, on};
}

LightCones::Points LightCones::seen(std::span<const Vec3> corners) const {
  Points points;
  points.corners = corners;
  points.ways.count = corners.size();
  for (std::size_t i = 0; i < std::size(points.ways.x); ++i) {
    const Vec3 way = corners[i < corners.size() ? i : 0] - light_.position;
    points.ways.x[i] = way.x;
    points.ways.y[i] = way.y;
    points.ways.z[i] = way.z;
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

/// Whether points lie in a cone for sure; if they may, adds it. `asked` are the bounds that may
/// part them.
bool LightCones::add(const LightCone& cone, const Points& points, const Segment* on,
                     std::uint32_t asked, Found& found) const {
  const std::uint32_t parting = lightKernels().findParting(points.ways, boundsOf(cone, on), asked,
                                                           points.margin, points.reach);
  if (parting == kBehindBound) return false;
  if (parting == 0 && !cone.isDoubtful) return true;
  found.push_back({&cone, parting});
  return false;
}

/// The same of several cones. Most of them are told by their sides, many at once.
bool LightCones::addSpanning(Range cones, const Points& points, const Segment* on,
                             Found& found) const {
  std::array<std::uint32_t, 64> spanning;
  for (std::size_t first = cones.first; first < cones.last; first += spanning.size()) {
    const ConeSides sides{&sides_.beginX[first], &sides_.beginY[first], &sides_.endX[first],
                          &sides_.endY[first]};
    const std::size_t count = lightKernels().findSpanning(
        points.ways, sides, std::min(spanning.size(), cones.last - first), points.margin,
        spanning.data());
    for (const std::uint32_t i : std::span(spanning).first(count))
      if (add(found_.cones[first + i], points, on, kAllBounds, found)) return true;
  }
  return false;
}

void LightCones::findSeen(const Points& points, const Segment* on, std::span<const Doubt> doubts,
                          const Samples& samples, Parting& parting, double* seen) const {
  auto& [parts, cones] = parting;
  parts.clear();
  cones.clear();
  for (const Doubt& doubt : doubts) {
    const std::size_t before = parts.size();
    const ConeBounds bounds = boundsOf(*doubt.cone, on);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if ((doubt.parting >> std::min(i, kBoundBits - 1) & 1) == 0) continue;
      const ConeBound bound = bounds[i];
      parts.push_back({bound.normal, bound.offset, bound.slack(points.margin, points.reach)});
    }
    cones.push_back({parts.size() - before, doubt.cone->isDoubtful});
  }
  for (std::size_t row = 0; row < samples.rows; ++row)
    lightKernels().findSeen(samples.arrays.from(row * samples.stride), samples.columns,
                            light_.position, cones, parts.data(), seen + row * samples.stride);
}

/// Whether cones, each of which begins at the very vertex where another ends, hold all that lies
/// between the begin of the first and the end of the last: on whichever side of the vertex a ray
/// passes, one of the two lights what it goes to.
bool LightCones::isRow(std::span<const Doubt> doubts) {
  if (std::ranges::any_of(doubts, &Doubt::elsewhere)) return false;
  const auto first = std::ranges::find(doubts, false, &Doubt::atBegin);
  if (first == doubts.end()) return false;
  const Doubt* last = &*first;
  for (std::size_t steps = 0; last->atEnd(); ++steps) {
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
  return std::ranges::any_of(points.corners, [&](Vec3 p) {
    const double share = dot(along, p.xy() - light_.position.xy() - start);
    return share < margin || share > wall.length * wall.length - margin;
  });
}

bool LightCones::find(SectorId sector, const Segment* on, const Points& points,
                      Found& found) const {
  const std::size_t before = found.size();
  const auto range = rangeOf_.find(sector.value);
  if (range == rangeOf_.end()) return false;
  const Range ofSector = range->second;
  const auto isAnyTo = [&](const Segment* wall) {
    const auto cones = std::span(found_.cones).first(ofSector.last).subspan(ofSector.first);
    const auto indexOf = [&](auto place) {
      return ofSector.first + static_cast<std::size_t>(place - cones.begin());
    };
    return addSpanning({indexOf(std::ranges::lower_bound(cones, wall, {}, &LightCone::to)),
                        indexOf(std::ranges::upper_bound(cones, wall, {}, &LightCone::to))},
                       points, on, found);
  };
  const bool isLit = !on || comesToEndOf(*on, points) ? addSpanning(ofSector, points, on, found)
                                                      : isAnyTo(nullptr) || isAnyTo(on);
  return isLit || isRow(std::span(found).subspan(before));
}

bool LightCones::narrow(const Points& points, const Segment* on, Found& found, std::size_t first,
                        std::size_t last) const {
  const std::size_t before = found.size();
  for (std::size_t i = first; i < last; ++i)
    if (add(*found[i].cone, points, on, found[i].parting, found)) return true;
  return isRow(std::span(found).subspan(before));
}

}  // namespace hearth
