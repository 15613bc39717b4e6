#include "light/beam_tree/beam_tree_builder.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "light/beam_tree/beam_planes.h"
#include "light/grid/slope_reach.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// The maximum number of beams per light. Lights of real levels need fewer.
std::size_t mostBeams(const Level& level) { return 1024 + 8 * level.segments.size(); }

/// Whether two directions are one, or lie the other way round.
bool isNarrow(Vec2 begin, Vec2 end) {
  const double sine = cross(begin, end);
  return sine <= 0 || (sine <= kNarrow * length(begin) * length(end) && dot(begin, end) > 0);
}

/// As squares: this is asked of every wall of every window.
bool isNear(Vec2 a, Vec2 b) {
  const double sine = cross(a, b);
  return dot(a, b) > 0 && sine * sine <= kNarrow * kNarrow * dot(a, a) * dot(b, b);
}

/// Whether a direction lies between two others that are less than 180 degrees apart.
bool isBetween(Vec2 begin, Vec2 end, Vec2 direction) {
  return cross(begin, direction) >= 0 && cross(direction, end) >= 0;
}

Vec2 unit(Vec2 direction) { return (1 / length(direction)) * direction; }

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
class Finder {
 public:
  Finder(const Scene& scene, const Raytracer::Source& light, double reach)
      : scene_(scene),
        reach_(reach),
        light_(light.position),
        sector_(light.sector),
        planes_(light.position) {}

  BeamSet find(std::size_t mostBytes) {
    // The first four windows are turned slightly, so that axis-aligned walls do not lie on their
    // borders.
    constexpr Vec2 kAhead{0.9921875, 0.124755859375};
    Vec2 direction = kAhead;
    for (int quarter = 0; quarter < 4; ++quarter, direction = turned90(direction))
      windows_.push_back({sector_, nullptr, direction, turned90(direction), {}, false, {}});
    const std::size_t most = mostBeams(scene_.level());
    while (!windows_.empty() && found_.beams.size() < most && found_.bytes() < mostBytes) {
      const Window window = windows_.back();
      windows_.pop_back();
      visit(window);
    }
    found_.isComplete = windows_.empty();
    found_.beams = sorted(found_.beams);
    return std::move(found_);
  }

 private:
  struct Planes {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };

  /// A flat portal, seen from where rays come from.
  struct Hatch {
    double z;
    bool isFloor;
    const Segment* from;  ///< rays come to it beyond this wall, if any
    const Segment* to;    ///< and before this one
  };

  /// An entry into a sector. Directions lead from the light to the vertices of walls.
  struct Window {
    SectorId sector;
    const Segment* from;
    Vec2 begin;
    Vec2 end;
    Planes planes;
    bool isDoubtful;
    std::optional<Hatch> hatch;
  };

  /// What of a wall lies in a window, in fractions of a straight line across that.
  struct Part {
    const Segment* wall;
    bool isEntrance;  ///< seen from its back
    double first;
    double last;
  };
  struct Bound {
    double fraction;
    Vec2 direction;
  };

  /// From where a ray comes into a sector to where it leaves it.
  struct Stretch {
    const Segment* from;
    const Segment* to;

    friend bool operator==(Stretch, Stretch) = default;
  };
  /// The same all along a part of a window.
  struct Visible {
    Stretch stretch;
    Vec2 begin;
    Vec2 end;
  };

  Vec2 fromLight(Vec2 p) const { return p - light_.xy(); }
  double distanceTo(const Segment& wall, Vec2 direction) const {
    return distanceToLine(light_, wall, direction);
  }

  static double fractionOf(const Window& window, Vec2 direction) {
    const double before = cross(window.begin, direction);
    const double after = cross(direction, window.end);
    return std::clamp(before / (before + after), 0.0, 1.0);
  }

  void findParts(const Window& window) {
    parts_.clear();
    bounds_.clear();
    bounds_.push_back({0, window.begin});
    bounds_.push_back({1, window.end});
    for (const Segment& wall : scene_.segmentsOf(scene_[window.sector])) {
      const Vec2 a = fromLight(wall.p0);
      const Vec2 b = fromLight(wall.p1);
      if (isNear(a, b)) {
        addBound(window, a);
        addBound(window, b);
      } else if (cross(a, b) > 0) {
        addPart(window, {&wall, false, 0, 1}, a, b);
      } else if (window.hatch) {
        addPart(window, {&wall, true, 0, 1}, b, a);
      }
    }
    std::ranges::sort(parts_, {}, &Part::first);
    std::ranges::stable_sort(bounds_, {}, &Bound::fraction);
  }

  void addBound(const Window& window, Vec2 direction) {
    if (isBetween(window.begin, window.end, direction) || isNear(window.begin, direction) ||
        isNear(window.end, direction))
      bounds_.push_back({fractionOf(window, direction), direction});
  }

  void addPart(const Window& window, Part part, Vec2 a, Vec2 b) {
    addBound(window, a);
    addBound(window, b);
    if (!isBetween(a, b, window.begin)) {
      if (!isBetween(window.begin, window.end, a)) return;
      part.first = fractionOf(window, a);
    }
    if (!isBetween(a, b, window.end)) {
      if (!isBetween(window.begin, window.end, b)) return;
      part.last = fractionOf(window, b);
    }
    parts_.push_back(part);
  }

  /// Goes along the window from one vertex to the next, and looks where rays go in between.
  void visit(const Window& window) {
    findParts(window);
    visible_.clear();
    active_.clear();
    std::size_t next = 0;
    std::size_t begin = 0;
    for (std::size_t i = 1; i < bounds_.size(); ++i) {
      if (isNarrow(bounds_[i - 1].direction, bounds_[i].direction)) continue;
      const double middle = (bounds_[i - 1].fraction + bounds_[i].fraction) / 2;
      while (next < parts_.size() && parts_[next].first < middle)
        active_.push_back(&parts_[next++]);
      std::erase_if(active_, [middle](const Part* part) { return part->last < middle; });
      findStretches(window, unit(bounds_[i - 1].direction) + unit(bounds_[i].direction));
      goOn(window, begin, i - 1, bounds_[i].direction);
      begin = i;
    }
    stretches_.clear();
    goOn(window, begin, bounds_.size() - 1, {});
  }

  /// Of rays between two vertices.
  void findStretches(const Window& window, Vec2 direction) {
    stretches_.clear();
    crossings_.clear();
    for (const Part* part : active_)
      crossings_.push_back({distanceTo(*part->wall, direction), part->wall, part->isEntrance});
    if (window.hatch) return findStretchesAcross(*window.hatch, direction);
    const double entry = beyond(window.from, direction);
    std::erase_if(crossings_, [entry](const Crossing& c) { return c.distance < entry; });
    const auto nearest = std::ranges::min_element(crossings_, {}, &Crossing::distance);
    if (nearest != crossings_.end()) stretches_.push_back({window.from, nearest->wall});
  }

  double beyond(const Segment* wall, Vec2 direction) const {
    return wall ? distanceTo(*wall, direction) * (1 - kSameDistance) : 0;
  }

  /// Rays come through a flat portal into each stretch in which some of it lies.
  void findStretchesAcross(const Hatch& hatch, Vec2 direction) {
    std::ranges::sort(crossings_, {}, &Crossing::distance);
    const double least = beyond(hatch.from, direction);
    const double most = distanceTo(*hatch.to, direction) * (1 + kSameDistance);
    const Segment* from = nullptr;
    double begin = 0;
    for (const Crossing& crossing : crossings_) {
      if (!crossing.isEntrance && crossing.distance >= least && begin <= most)
        stretches_.push_back({from, crossing.wall});
      from = crossing.wall;
      begin = crossing.distance;
    }
  }

  /// Begins what `stretches_` show from a bound to the direction `end`, and ends what they do not.
  /// The bounds from `last` to this one are vertices in one line with the light. A ray may pass
  /// between them unless the same wall continues behind them.
  void goOn(const Window& window, std::size_t last, std::size_t bound, Vec2 end) {
    bool isGap = false;
    for (std::size_t i = last; i < bound; ++i)
      isGap |= bounds_[i].direction != bounds_[i + 1].direction;
    seen_.clear();
    bool slips = false;
    for (const Stretch stretch : stretches_) {
      const auto before = std::ranges::find(visible_, stretch, &Visible::stretch);
      const bool goesOn = before != visible_.end();
      seen_.push_back({stretch, goesOn ? before->begin : bounds_[bound].direction, end});
      slips |= endsBetween(stretch, last, bound);
      if (goesOn) visible_.erase(before);
    }
    for (const Visible& visible : visible_) slips |= endsBetween(visible.stretch, last, bound);
    if (isGap && slips) addLine(window.sector, unit(bounds_[bound].direction));
    for (const Visible& visible : visible_) finish(window, visible);
    visible_.swap(seen_);
  }

  /// Whether one of the walls of a stretch has a vertex at one of the bounds from `last` to
  /// `bound`.
  bool endsBetween(Stretch stretch, std::size_t last, std::size_t bound) const {
    for (std::size_t i = last; i <= bound; ++i)
      for (const Segment* wall : {stretch.from, stretch.to})
        if (wall && (bounds_[i].direction == fromLight(wall->p0) ||
                     bounds_[i].direction == fromLight(wall->p1)))
          return true;
    return false;
  }

  void finish(const Window& window, const Visible& visible) {
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
      const Hatch hatch = *window.hatch;
      planes_.add(beam, *beam.to, {hatch.z, hatch.z, !hatch.isFloor});
      if (beam.from) planes_.add(beam, *beam.from, {hatch.z, hatch.z, hatch.isFloor});
      if (planes_.leaveNothingOf(beam)) return;
      const Planes planes = keepPlanes();
      beam.firstPlane = planes.first;
      beam.lastPlane = planes.last;
    }
    found_.beams.push_back(beam);
    goThroughOpenings(beam, visible);
    goThroughFlats(beam, visible);
  }

  Planes keepPlanes() {
    const auto first = static_cast<std::uint32_t>(found_.planes.size());
    found_.planes.insert(found_.planes.end(), planes_.all().begin(), planes_.all().end());
    return {first, static_cast<std::uint32_t>(found_.planes.size())};
  }

  void goThroughOpenings(const Beam& beam, const Visible& visible) {
    const std::span<const LightOpening> openings = scene_.lightOpeningsOf(*beam.to);
    if (openings.empty() || distanceToWall(light_, beam, *beam.to) > reach_) return;
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

  void goThroughFlats(const Beam& beam, const Visible& visible) {
    const Sector& sector = scene_[beam.sector];
    if (sector.floor.flatPortal && !sector.floor.isSky)
      goThroughFlat(beam, visible, {scene_.zFloor(sector), true, beam.from, beam.to},
                    scene_[*sector.floor.flatPortal].lower);
    if (sector.ceiling.flatPortal && !sector.ceiling.isSky)
      goThroughFlat(beam, visible, {scene_.zCeiling(sector), false, beam.from, beam.to},
                    scene_[*sector.ceiling.flatPortal].upper);
  }

  void goThroughFlat(const Beam& beam, const Visible& visible, const Hatch& hatch,
                     const std::vector<SectorId>& members) {
    if (hasSlopeAt(scene_, scene_[beam.sector], hatch.z)) return forget(members);
    const double before = hatch.isFloor ? light_.z - hatch.z : hatch.z - light_.z;
    if (before < -kPositionSlack) return;
    if (before < kPositionSlack) return forget(members);
    planes_.begin(found_.planesOf(beam));
    planes_.add(beam, *beam.to, {hatch.z, hatch.z, !hatch.isFloor});
    if (planes_.leaveNothingOf(beam)) return;
    const Planes planes = keepPlanes();
    for (const SectorId member : members)
      if (hasSlopeAt(scene_, scene_[member], hatch.z) || isAboveWall(scene_[member]))
        forget({member});
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

  /// A direction in which rounding decides which walls rays meet: whatever they can come to from
  /// the sector on is doubtful along it.
  void addLine(SectorId from, Vec2 direction) {
    std::vector<SectorId> sectors{from};
    const auto goTo = [&](SectorId sector) { sectors.push_back(sector); };
    while (!sectors.empty()) {
      const SectorId id = sectors.back();
      sectors.pop_back();
      if (!lines_.insert({id.value, direction.x, direction.y}).second) continue;
      found_.beams.push_back(
          {id, nullptr, nullptr, direction, direction, direction, direction, 0, 0, true});
      for (const Segment& wall : scene_.segmentsOf(scene_[id]))
        if (const auto openings = scene_.lightOpeningsOf(wall);
            !openings.empty() && touches(wall, direction))
          for (const LightOpening& opening : openings) goTo(opening.next);
      forEachBehindFlats(id, goTo);
    }
  }

  /// Whether a line from the light comes to the wall, perhaps, and it does not clearly face away.
  bool touches(const Segment& wall, Vec2 direction) const {
    const Vec2 a = fromLight(wall.p0);
    const Vec2 b = fromLight(wall.p1);
    const double far = std::max(length(a), length(b));
    const double narrow = 4 * kNarrow * far;
    return cross(a, b) >= -narrow * far && cross(a, direction) >= -narrow &&
           cross(direction, b) >= -narrow && std::max(dot(a, direction), dot(b, direction)) > 0;
  }

  template <typename Visit>
  void forEachBehindFlats(SectorId id, Visit&& visit) const {
    const Sector& sector = scene_[id];
    if (sector.floor.flatPortal)
      std::ranges::for_each(scene_[*sector.floor.flatPortal].lower, visit);
    if (sector.ceiling.flatPortal)
      std::ranges::for_each(scene_[*sector.ceiling.flatPortal].upper, visit);
  }

  /// Says nothing of sectors any more, and of what rays can come to from there.
  void forget(std::vector<SectorId> sectors) {
    const auto goTo = [&](SectorId sector) { sectors.push_back(sector); };
    while (!sectors.empty()) {
      const SectorId id = sectors.back();
      sectors.pop_back();
      if (!found_.unknown.insert(id.value).second) continue;
      forEachBehindFlats(id, goTo);
      for (const Segment& wall : scene_.segmentsOf(scene_[id])) {
        const Vec2 a = fromLight(wall.p0);
        const Vec2 b = fromLight(wall.p1);
        if (cross(a, b) < -kNarrow * length(a) * length(b)) continue;
        for (const LightOpening& opening : scene_.lightOpeningsOf(wall)) goTo(opening.next);
      }
    }
  }

  struct Crossing {
    double distance;
    const Segment* wall;
    bool isEntrance;
  };

  Scene scene_;
  double reach_;
  Vec3 light_;
  SectorId sector_;
  BeamSet found_;
  std::vector<Window> windows_;  ///< still to visit
  // Of the window at hand:
  std::vector<Part> parts_;
  std::vector<Bound> bounds_;
  std::vector<const Part*> active_;
  std::vector<Crossing> crossings_;
  std::vector<Stretch> stretches_;
  std::vector<Visible> visible_;
  std::vector<Visible> seen_;
  BeamPlanes planes_;
  std::set<std::tuple<std::uint32_t, double, double>> lines_;
};

}  // namespace

BeamSet findLightBeams(const Scene& scene, const Raytracer::Source& light, double reach,
                       std::size_t mostBytes) {
  return Finder(scene, light, reach).find(mostBytes);
}

}  // namespace hearth
