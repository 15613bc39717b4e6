#include "light/beam_tree/beam_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "light/beam_tree/beam_tree_builder.h"
#include "light/sampling/target_air.h"
#include "light/sight/ray_rounding.h"
#include "math/tolerance.h"

namespace hearth {

BeamTree::BeamTree(const Scene& scene, const Raytracer::Source& light, double reach,
                   std::size_t mostBytes)
    : scene_(scene), light_(light), found_(findLightBeams(scene, light, reach, mostBytes)) {
  const std::vector<Beam>& beams = found_.beams;
  for (auto* side : {&sides_.beginX, &sides_.beginY, &sides_.endX, &sides_.endY})
    side->reserve(beams.size());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    ++rangeOf_.try_emplace(beams[i].sector.value, Range{i, i}).first->second.last;
    sides_.beginX.push_back(-beams[i].begin.y);
    sides_.beginY.push_back(beams[i].begin.x);
    sides_.endX.push_back(beams[i].end.y);
    sides_.endY.push_back(-beams[i].end.x);
  }
}

BeamBounds BeamTree::boundsOf(const Beam& beam, const Segment* on) const {
  return {beam, found_.planesOf(beam), light_.position, on};
}

BeamTree::Points BeamTree::seen(std::span<const Vec3> corners) const {
  Points points;
  points.corners = corners;
  points.directions.count = corners.size();
  for (std::size_t i = 0; i < std::size(points.directions.x); ++i) {
    const Vec3 direction = corners[i < corners.size() ? i : 0] - light_.position;
    points.directions.x[i] = direction.x;
    points.directions.y[i] = direction.y;
    points.directions.z[i] = direction.z;
    points.reach = std::max(points.reach,
                            std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
  }
  points.noise = roundingOf(largestCoordinate(light_.position) + points.reach);
  points.margin = rayMargin(points.noise) + kNarrow * points.reach;
  return points;
}

bool BeamTree::knows(SectorId sector, const Plane& plane, const Points& points) const {
  return found_.isComplete && !found_.unknown.contains(sector.value) &&
         plane.inFront(light_.position) >= leastInFront(points.noise, points.reach) &&
         isAirClear(scene_, scene_[sector],
                    {light_.position, 0, points.reach, points.noise, points.margin},
                    points.corners);
}

/// Whether points lie in a beam for sure; if they may, adds it. `asked` are the bounds that may
/// part them.
bool BeamTree::add(const Beam& beam, const Points& points, const Segment* on, std::uint32_t asked,
                   Found& found) const {
  const std::uint32_t parting = lightKernels().findParting(points.directions, boundsOf(beam, on),
                                                           asked, points.margin, points.reach);
  if (parting == kBehindBound) return false;
  if (parting == 0 && !beam.isDoubtful) return true;
  found.push_back({&beam, parting});
  return false;
}

/// The same of several beams. Most of them are told by their sides, many at once.
bool BeamTree::addSpanning(Range beams, const Points& points, const Segment* on,
                           Found& found) const {
  std::array<std::uint32_t, 64> spanning;
  for (std::size_t first = beams.first; first < beams.last; first += spanning.size()) {
    const BeamSides sides{&sides_.beginX[first], &sides_.beginY[first], &sides_.endX[first],
                          &sides_.endY[first]};
    const std::size_t count = lightKernels().findSpanning(
        points.directions, sides, std::min(spanning.size(), beams.last - first), points.margin,
        spanning.data());
    for (const std::uint32_t i : std::span(spanning).first(count))
      if (add(found_.beams[first + i], points, on, kAllBounds, found)) return true;
  }
  return false;
}

void BeamTree::findSeen(const Points& points, const Segment* on, std::span<const Doubt> doubts,
                        const Samples& samples, Parting& parting, double* seen) const {
  auto& [parts, beams] = parting;
  parts.clear();
  beams.clear();
  for (const Doubt& doubt : doubts) {
    const std::size_t before = parts.size();
    const BeamBounds bounds = boundsOf(*doubt.beam, on);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if ((doubt.parting >> std::min(i, kBoundBits - 1) & 1) == 0) continue;
      const BeamBound bound = bounds[i];
      parts.push_back({bound.normal, bound.offset, bound.slack(points.margin, points.reach)});
    }
    beams.push_back({parts.size() - before, doubt.beam->isDoubtful});
  }
  for (std::size_t row = 0; row < samples.rows; ++row)
    lightKernels().findSeen(samples.arrays.from(row * samples.stride), samples.columns,
                            light_.position, beams, parts.data(), seen + row * samples.stride);
}

/// Whether beams, each of which begins at the very vertex where another ends, hold all that lies
/// between the begin of the first and the end of the last: on whichever side of the vertex a ray
/// passes, one of the two lights what it goes to.
bool BeamTree::isRow(std::span<const Doubt> doubts) {
  if (std::ranges::any_of(doubts, &Doubt::elsewhere)) return false;
  const auto first = std::ranges::find(doubts, false, &Doubt::atBegin);
  if (first == doubts.end()) return false;
  const Doubt* last = &*first;
  for (std::size_t steps = 0; last->atEnd(); ++steps) {
    const auto next = std::ranges::find(doubts, last->beam->endsAt,
                                        [](const Doubt& doubt) { return doubt.beam->beginsAt; });
    if (next == doubts.end() || steps == doubts.size()) return false;
    last = &*next;
  }
  return true;
}

/// Whether points on a wall may lie on its end, and so on the next wall, too.
bool BeamTree::comesToEndOf(const Segment& wall, const Points& points) const {
  const Vec2 along = wall.p1 - wall.p0;
  const Vec2 start = wall.p0 - light_.position.xy();
  const double margin = points.margin * wall.length;
  return std::ranges::any_of(points.corners, [&](Vec3 p) {
    const double alongTimesLength = dot(along, p.xy() - light_.position.xy() - start);
    return alongTimesLength < margin || alongTimesLength > wall.length * wall.length - margin;
  });
}

bool BeamTree::find(SectorId sector, const Segment* on, const Points& points, Found& found) const {
  const std::size_t before = found.size();
  const auto range = rangeOf_.find(sector.value);
  if (range == rangeOf_.end()) return false;
  const Range ofSector = range->second;
  const auto isAnyTo = [&](const Segment* wall) {
    const auto beams = std::span(found_.beams).first(ofSector.last).subspan(ofSector.first);
    const auto indexOf = [&](auto place) {
      return ofSector.first + static_cast<std::size_t>(place - beams.begin());
    };
    return addSpanning({indexOf(std::ranges::lower_bound(beams, wall, {}, &Beam::to)),
                        indexOf(std::ranges::upper_bound(beams, wall, {}, &Beam::to))},
                       points, on, found);
  };
  const bool isLit = !on || comesToEndOf(*on, points) ? addSpanning(ofSector, points, on, found)
                                                      : isAnyTo(nullptr) || isAnyTo(on);
  return isLit || isRow(std::span(found).subspan(before));
}

bool BeamTree::narrow(const Points& points, const Segment* on, Found& found, std::size_t first,
                      std::size_t last) const {
  const std::size_t before = found.size();
  for (std::size_t i = first; i < last; ++i)
    if (add(*found[i].beam, points, on, found[i].parting, found)) return true;
  return isRow(std::span(found).subspan(before));
}

}  // namespace hearth
