#include "light/beam_tree/beam_tree_builder.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "light/beam_tree/beam_doubts.h"
#include "light/beam_tree/beam_planes.h"
#include "light/beam_tree/beam_sweep.h"
#include "light/grid/slope_reach.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// The maximum number of beams per light. Lights of real levels need fewer.
std::size_t maxBeams(const Level& level) { return 1024 + 8 * level.segments.size(); }

/// Sorts the beams by sector and wall. Doubtful beams have no wall and come first. Beams are large,
/// so their indices are sorted.
std::vector<Beam> sorted(const std::vector<Beam>& beams) {
  std::vector<std::tuple<SectorId, const Segment*, std::size_t>> order;
  order.reserve(beams.size());
  for (std::size_t i = 0; i < beams.size(); ++i)
    order.emplace_back(beams[i].sector, beams[i].to, i);
  std::ranges::sort(order);
  std::vector<Beam> result;
  result.reserve(beams.size());
  for (const auto& place : order) result.push_back(beams[std::get<std::size_t>(place)]);
  return result;
}

/// Follows what the light sees from its sector on.
class BeamTreeBuilder {
 public:
  BeamTreeBuilder(const Scene& scene, const Raytracer::Source& light, const BeamLimits& limits)
      : scene_(scene),
        limits_(limits),
        light_(light.position),
        sector_(light.sector),
        planes_(light.position),
        sweep_(scene, light.position),
        doubts_(scene, light.position, found_) {
    if (!limits.region) return;
    const Box region = grown(*limits.region, BeamLimits::kBesideRegion);
    regionCorners_ = {
        region.min, region.max, {region.min.x, region.max.y}, {region.max.x, region.min.y}};
  }

  BeamSet build() {
    // The first four windows are turned slightly, so that axis-aligned walls do not lie on their
    // borders.
    constexpr Vec2 kAhead{0.9921875, 0.124755859375};
    Vec2 direction = kAhead;
    for (int quarter = 0; quarter < 4; ++quarter, direction = turned90(direction))
      if (mayLeadToRegion(direction, turned90(direction)))
        windows_.push_back({sector_, nullptr, direction, turned90(direction), {}, false, {}});
    const std::size_t most = maxBeams(scene_.level());
    while (!windows_.empty() && found_.beams.size() < most && found_.bytes() < limits_.maxBytes) {
      const BeamWindow window = windows_.back();
      windows_.pop_back();
      sweep_.sweep(window);
      for (const Vec2 doubtful : sweep_.doubtfulDirections())
        doubts_.addLine(window.sector, doubtful);
      for (const VisibleStretch& visible : sweep_.visible()) finish(window, visible);
    }
    found_.isComplete = windows_.empty();
    found_.beams = sorted(found_.beams);
    return std::move(found_);
  }

 private:
  Vec2 fromLight(Vec2 p) const { return p - light_.xy(); }

  /// Whether no point of the region is to the left of a line from `p` along `direction`.
  bool isRegionRightOf(Vec2 p, Vec2 direction) const {
    return !regionCorners_.empty() && std::ranges::all_of(regionCorners_, [&](Vec2 corner) {
      return cross(direction, corner - p) < 0;
    });
  }

  /// Whether some of the region may lie between two directions from the light.
  bool mayLeadToRegion(Vec2 begin, Vec2 end) const {
    if (limits_.region && limits_.region->isEmpty()) return false;
    return !isRegionRightOf(light_.xy(), begin) && !isRegionRightOf(light_.xy(), -1 * end);
  }

  void finish(const BeamWindow& window, const VisibleStretch& visible) {
    if (!mayLeadToRegion(visible.begin, visible.end)) return;
    Beam beam{.sector = window.sector,
              .from = visible.stretch.from,
              .to = visible.stretch.to,
              .begin = unit(visible.begin),
              .end = unit(visible.end),
              .beginsAt = visible.begin,
              .endsAt = visible.end,
              .firstPlane = window.planes.first,
              .lastPlane = window.planes.last,
              .isDoubtful = window.isDoubtful};
    if (window.hatch) {
      planes_.begin(found_.planesOf(beam));
      const BeamHatch hatch = *window.hatch;
      planes_.add(beam, *beam.to, {hatch.z, hatch.z, !hatch.isFloor});
      if (beam.from) planes_.add(beam, *beam.from, {hatch.z, hatch.z, hatch.isFloor});
      if (planes_.leaveNothingOf(beam)) return;
      const PlaneRange planes = keepPlanes();
      beam.firstPlane = planes.first;
      beam.lastPlane = planes.last;
    }
    found_.beams.push_back(beam);
    goThroughOpenings(beam, visible);
    goThroughFlats(beam, visible);
  }

  PlaneRange keepPlanes() {
    const auto first = static_cast<std::uint32_t>(found_.planes.size());
    found_.planes.insert(found_.planes.end(), planes_.all().begin(), planes_.all().end());
    return {first, static_cast<std::uint32_t>(found_.planes.size())};
  }

  void goThroughOpenings(const Beam& beam, const VisibleStretch& visible) {
    const std::span<const LightOpening> openings = scene_.lightOpeningsOf(*beam.to);
    if (openings.empty() || distanceToWall(light_, beam, *beam.to) > limits_.reach) return;
    if (isRegionRightOf(beam.to->p0, beam.to->p0 - beam.to->p1)) return;
    for (const LightOpening& opening : openings) {
      planes_.begin(found_.planesOf(beam));
      addBounds(beam, opening);
      if (planes_.leaveNothingOf(beam)) continue;
      windows_.push_back({opening.next, &scene_[opening.twin], visible.begin, visible.end,
                          keepPlanes(), beam.isDoubtful || hasHoles(opening), std::nullopt});
    }
  }

  bool hasHoles(const LightOpening& opening) const {
    return !scene_.maskedMiddlesIn(opening).empty();
  }

  void goThroughFlats(const Beam& beam, const VisibleStretch& visible) {
    const Sector& sector = scene_[beam.sector];
    if (sector.floor.flatPortal && !sector.floor.isSky)
      goThroughFlat(beam, visible, {scene_.zFloor(sector), true, beam.from, beam.to},
                    scene_[*sector.floor.flatPortal].lower);
    if (sector.ceiling.flatPortal && !sector.ceiling.isSky)
      goThroughFlat(beam, visible, {scene_.zCeiling(sector), false, beam.from, beam.to},
                    scene_[*sector.ceiling.flatPortal].upper);
  }

  void goThroughFlat(const Beam& beam, const VisibleStretch& visible, const BeamHatch& hatch,
                     const std::vector<SectorId>& members) {
    if (hasSlopeAt(scene_, scene_[beam.sector], hatch.z)) return doubts_.forget(members);
    const double before = hatch.isFloor ? light_.z - hatch.z : hatch.z - light_.z;
    if (before < -kPositionSlack) return;
    if (before < kPositionSlack) return doubts_.forget(members);
    planes_.begin(found_.planesOf(beam));
    planes_.add(beam, *beam.to, {hatch.z, hatch.z, !hatch.isFloor});
    if (planes_.leaveNothingOf(beam)) return;
    const PlaneRange planes = keepPlanes();
    for (const SectorId member : members)
      if (hasSlopeAt(scene_, scene_[member], hatch.z) || isAboveWall(scene_[member]))
        doubts_.forget({member});
      else
        windows_.push_back(
            {member, nullptr, visible.begin, visible.end, planes, beam.isDoubtful, hatch});
  }

  /// Whether the light stands on a wall, as seen on the map.
  bool isAboveWall(const Sector& sector) const {
    return std::ranges::any_of(scene_.segmentsOf(sector), [&](const Segment& wall) {
      return length(fromLight(nearestOnSegment(wall.p0, wall.p1, light_.xy()))) < kPositionSlack;
    });
  }

  /// Of the opening, and of slopes on both sides of it.
  void addBounds(const Beam& beam, const LightOpening& opening) {
    const Segment& wall = *beam.to;
    const SegmentGeometry& near = scene_.geometryOf(wall);
    const SegmentGeometry& far = scene_.geometryOf(scene_[opening.twin]);
    const Sector& sector = scene_[beam.sector];
    const Sector& next = scene_[opening.next];
    const auto add = [&](double z0, double z1, bool isBelow) {
      planes_.add(beam, wall, {z0, z1, isBelow});
    };
    if (std::isfinite(opening.zBottom)) add(opening.zBottom, opening.zBottom, true);
    if (std::isfinite(opening.zTop)) add(opening.zTop, opening.zTop, false);
    const auto meets = [](const Flat& flat, const std::optional<Slope>& slope) {
      return !flat.isSky && (slope || flat.flatPortal);
    };
    if (meets(sector.floor, sector.floorSlope)) add(near.air0.zBottom, near.air1.zBottom, true);
    if (meets(sector.ceiling, sector.ceilingSlope)) add(near.air0.zTop, near.air1.zTop, false);
    if (next.floorSlope) add(far.air1.zBottom, far.air0.zBottom, true);
    if (next.ceilingSlope) add(far.air1.zTop, far.air0.zTop, false);
  }

  Scene scene_;
  BeamLimits limits_;
  std::vector<Vec2> regionCorners_;  ///< none if it is everywhere
  Vec3 light_;
  SectorId sector_;
  BeamSet found_;
  std::vector<BeamWindow> windows_;  ///< still to visit
  BeamPlanes planes_;
  BeamSweep sweep_;
  BeamDoubts doubts_;
};

}  // namespace

BeamSet findLightBeams(const Scene& scene, const Raytracer::Source& light,
                       const BeamLimits& limits) {
  return BeamTreeBuilder(scene, light, limits).build();
}

}  // namespace hearth
