#include "light/beam_tree/beam_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "light/ray_error.h"
#include "light/rays/target_air.h"
#include "math/tolerance.h"

namespace hearth {

BeamTree::BeamTree(const Scene& scene, const Raytracer::Source& light, const BeamLimits& limits)
    : scene_(scene),
      light_(light),
      region_(limits.region),
      found_(findLightBeams(scene, light, limits)) {
  const std::vector<Beam>& beams = found_.beams;
  walls_.reserve(beams.size());
  for (auto* side : {&sides_.beginX, &sides_.beginY, &sides_.endX, &sides_.endY})
    side->reserve(beams.size());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (bySector_.empty() || bySector_.back().sector != beams[i].sector)
      bySector_.push_back({beams[i].sector, {i, i}, {i, i}});
    ++bySector_.back().all.last;
    if (!beams[i].to) ++bySector_.back().withoutWall.last;
    walls_.push_back(beams[i].to);
    sides_.beginX.push_back(-beams[i].begin.y);
    sides_.beginY.push_back(beams[i].begin.x);
    sides_.endX.push_back(beams[i].end.y);
    sides_.endY.push_back(-beams[i].end.x);
  }
}

BeamBounds BeamTree::boundsOf(const Beam& beam, const Segment* on) const {
  return {beam, found_.planesOf(beam), light_.position, on};
}

BeamTree::Points BeamTree::pointsBetween(std::span<const Vec3> corners) const {
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

bool BeamTree::isInRegion(const Points& points) const {
  return !region_ || (points.margin < BeamLimits::kBesideRegion &&
                      std::ranges::all_of(points.corners, [this](Vec3 corner) {
                        return region_->contains(corner.xy());
                      }));
}

bool BeamTree::knows(SectorId sector, const Plane& plane, const Points& points) const {
  return found_.isComplete && !found_.unknown.contains(sector.value) && isInRegion(points) &&
         plane.inFront(light_.position) >= minInFront(points.noise, points.reach) &&
         isAirClear(scene_, scene_[sector],
                    {light_.position, 0, points.reach, points.noise, points.margin},
                    points.corners);
}

/// Whether points lie in a beam for sure; if they may, adds it. `asked` are the bounds that may
/// part them, and `known` those that do.
bool BeamTree::add(const Beam& beam, const Points& points, const Segment* on, std::uint32_t asked,
                   std::uint32_t known, Candidates& candidates) const {
  const std::uint32_t found = beamKernels().findStraddled(points.directions, boundsOf(beam, on),
                                                          asked, points.margin, points.reach);
  if (found == kBehindBound) return false;
  const std::uint32_t straddled = found | known;
  if (straddled == 0 && !beam.isDoubtful) return true;
  candidates.push_back({&beam, straddled});
  return false;
}

/// The same of several beams. Most of them are told by their sides, many at once.
bool BeamTree::addSpanning(Range beams, const Points& points, const Segment* on,
                           Candidates& candidates) const {
  std::array<SpanningBeam, 64> spanning;
  for (std::size_t first = beams.first; first < beams.last; first += spanning.size()) {
    const BeamSides planes{&sides_.beginX[first], &sides_.beginY[first], &sides_.endX[first],
                           &sides_.endY[first]};
    const std::size_t count = beamKernels().findSpanning(
        points.directions, planes, std::min(spanning.size(), beams.last - first), points.margin,
        spanning.data());
    for (const auto& [i, sides] : std::span(spanning).first(count))
      if (add(found_.beams[first + i], points, on, kAllBounds & ~(kAtBegin | kAtEnd), sides,
              candidates))
        return true;
  }
  return false;
}

void BeamTree::findSeen(const Points& points, const Segment* on,
                        std::span<const CandidateBeam> candidates, const SampleArrays& samples,
                        std::size_t count, Scratch& scratch, double* seen) const {
  auto& [parts, beams] = scratch;
  parts.clear();
  beams.clear();
  for (const CandidateBeam& candidate : candidates) {
    const std::size_t before = parts.size();
    const BeamBounds bounds = boundsOf(*candidate.beam, on);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if ((candidate.straddled >> std::min(i, kBoundBits - 1) & 1) == 0) continue;
      const BeamBound bound = bounds[i];
      parts.push_back({bound.normal, bound.offset, bound.slack(points.margin, points.reach)});
    }
    beams.push_back({parts.size() - before, candidate.beam->isDoubtful});
  }
  beamKernels().findSeen(samples, count, light_.position, beams, parts.data(), seen);
}

/// Whether beams, each of which begins at the very vertex where another ends, hold all that lies
/// between the begin of the first and the end of the last: on whichever side of the vertex a ray
/// passes, one of the two lights what it goes to.
bool BeamTree::isRow(std::span<const CandidateBeam> candidates) {
  if (std::ranges::any_of(candidates, &CandidateBeam::elsewhere)) return false;
  const auto first = std::ranges::find(candidates, false, &CandidateBeam::atBegin);
  if (first == candidates.end()) return false;
  const CandidateBeam* last = &*first;
  for (std::size_t steps = 0; last->atEnd(); ++steps) {
    const auto next =
        std::ranges::find(candidates, last->beam->endsAt,
                          [](const CandidateBeam& candidate) { return candidate.beam->beginsAt; });
    if (next == candidates.end() || steps == candidates.size()) return false;
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

/// Those of some beams of a sector that end at a wall.
BeamTree::Range BeamTree::upTo(const Segment& wall, Range beams) const {
  const auto walls = std::span(walls_).first(beams.last).subspan(beams.first);
  const auto indexOf = [&](auto place) {
    return beams.first + static_cast<std::size_t>(place - walls.begin());
  };
  return {indexOf(std::ranges::lower_bound(walls, &wall)),
          indexOf(std::ranges::upper_bound(walls, &wall))};
}

bool BeamTree::find(SectorId sector, const Segment* on, const Points& points,
                    Candidates& candidates) const {
  const std::size_t before = candidates.size();
  const auto there = std::ranges::lower_bound(bySector_, sector, {}, &BeamsOfSector::sector);
  if (there == bySector_.end() || there->sector != sector) return false;
  const Range all = there->all;
  const Range withoutWall = there->withoutWall;
  const bool isLit =
      !on || comesToEndOf(*on, points)
          ? addSpanning(all, points, on, candidates)
          : addSpanning(withoutWall, points, on, candidates) ||
                addSpanning(upTo(*on, {withoutWall.last, all.last}), points, on, candidates);
  return isLit || isRow(std::span(candidates).subspan(before));
}

bool BeamTree::narrow(const Points& points, const Segment* on, Candidates& candidates,
                      std::size_t first, std::size_t last) const {
  const std::size_t before = candidates.size();
  for (std::size_t i = first; i < last; ++i)
    if (add(*candidates[i].beam, points, on, candidates[i].straddled, 0, candidates)) return true;
  return isRow(std::span(candidates).subspan(before));
}

}  // namespace hearth
