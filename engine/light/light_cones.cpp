#include "light/light_cones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "light/slope_reach.h"
#include "math/planted_bug.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Of an angle: directions closer than this are one. Rounding turns none by as much, and at 1 km it
/// is less than the margin of a cone.
constexpr double kNarrow = 1e-11;

/// Share of a distance: walls of which one is this much nearer are equally far. More than rounding,
/// and less than two walls that meet are apart where kNarrow begins.
constexpr double kTie = 1e-14;

/// A light that sees more is not worth its memory.
std::size_t mostCones(const Level& level) {
  return std::min<std::size_t>(1 << 16, 1024 + 8 * level.segments.size());
}

/// Whether two directions are one, or lie the other way round.
bool isNarrow(Vec2 begin, Vec2 end) {
  const double sine = cross(begin, end);
  return sine <= 0 || (sine <= kNarrow * length(begin) * length(end) && dot(begin, end) > 0);
}

bool isNear(Vec2 a, Vec2 b) {
  return std::abs(cross(a, b)) <= kNarrow * length(a) * length(b) && dot(a, b) > 0;
}

/// Whether a direction lies between two others that are less than 180 degrees apart.
bool isBetween(Vec2 begin, Vec2 end, Vec2 way) {
  return cross(begin, way) >= 0 && cross(way, end) >= 0;
}

Vec2 unit(Vec2 way) { return (1 / length(way)) * way; }

double largestCoordinate(Vec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

double roundingOf(double size) { return 64 * std::numeric_limits<double>::epsilon() * size; }

/// Of cones in a list: those that say where something is doubtful first.
auto orderOf(const LightCone& cone) { return std::tuple(cone.sector, cone.to); }

}  // namespace

/// Follows what the light sees from its sector on.
class LightCones::Finder {
 public:
  Finder(const Level& level, double reach, LightCones& cones)
      : level_(level), reach_(reach), cones_(cones), light_(cones.light_.position) {}

  void find() {
    // Turned a little, so that nothing that is built square lies along their borders.
    constexpr Vec2 kAhead{0.9921875, 0.124755859375};
    Vec2 way = kAhead;
    for (int quarter = 0; quarter < 4; ++quarter, way = turned90(way))
      windows_.push_back({cones_.light_.sector, nullptr, way, turned90(way), {}, false, {}});
    const std::size_t most = mostCones(level_);
    while (!windows_.empty() && cones_.cones_.size() < most) {
      const Window window = windows_.back();
      windows_.pop_back();
      visit(window);
    }
    cones_.isComplete_ = windows_.empty();
    std::ranges::sort(cones_.cones_, {}, orderOf);
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

  /// A way into a sector. Directions lead from the light to the vertices of walls.
  struct Window {
    SectorId sector;
    const Segment* from;
    Vec2 begin;
    Vec2 end;
    Planes planes;
    bool isDoubtful;
    std::optional<Hatch> hatch;
  };

  /// What of a wall lies in a window, in shares of a straight line across that.
  struct Part {
    const Segment* wall;
    bool isEntrance;  ///< seen from its back
    double first;
    double last;
  };
  struct Bound {
    double share;
    Vec2 way;
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

  static double shareOf(const Window& window, Vec2 way) {
    const double before = cross(window.begin, way);
    const double after = cross(way, window.end);
    return std::clamp(before / (before + after), 0.0, 1.0);
  }

  void findParts(const Window& window) {
    parts_.clear();
    bounds_.clear();
    bounds_.push_back({0, window.begin});
    bounds_.push_back({1, window.end});
    for (const Segment& wall : level_.segmentsOf(level_[window.sector])) {
      const Vec2 a = fromLight(wall.p0);
      const Vec2 b = fromLight(wall.p1);
      if (planted(PlantedBug::ConeThroughPillars) && wall.loop > 0) continue;
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
    std::ranges::stable_sort(bounds_, {}, &Bound::share);
  }

  void addBound(const Window& window, Vec2 way) {
    if (isBetween(window.begin, window.end, way) || isNear(window.begin, way) ||
        isNear(window.end, way))
      bounds_.push_back({shareOf(window, way), way});
  }

  void addPart(const Window& window, Part part, Vec2 a, Vec2 b) {
    addBound(window, a);
    addBound(window, b);
    if (!isBetween(a, b, window.begin)) {
      if (!isBetween(window.begin, window.end, a)) return;
      part.first = shareOf(window, a);
    }
    if (!isBetween(a, b, window.end)) {
      if (!isBetween(window.begin, window.end, b)) return;
      part.last = shareOf(window, b);
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
      if (isNarrow(bounds_[i - 1].way, bounds_[i].way)) continue;
      const double middle = (bounds_[i - 1].share + bounds_[i].share) / 2;
      while (next < parts_.size() && parts_[next].first < middle)
        active_.push_back(&parts_[next++]);
      std::erase_if(active_, [middle](const Part* part) { return part->last < middle; });
      findStretches(window, unit(bounds_[i - 1].way) + unit(bounds_[i].way));
      goOn(window, begin, i - 1, bounds_[i].way);
      begin = i;
    }
    stretches_.clear();
    goOn(window, begin, bounds_.size() - 1, {});
  }

  /// Metres, in lengths of `way`, to the line of a wall.
  double distanceTo(const Segment& wall, Vec2 way) const {
    const Vec2 along = wall.p1 - wall.p0;
    return cross(fromLight(wall.p0), along) / cross(way, along);
  }

  /// Of rays between two vertices.
  void findStretches(const Window& window, Vec2 way) {
    stretches_.clear();
    crossings_.clear();
    for (const Part* part : active_)
      crossings_.push_back({distanceTo(*part->wall, way), part->wall, part->isEntrance});
    if (window.hatch) return findStretchesAcross(*window.hatch, way);
    const double entry = beyond(window.from, way);
    std::erase_if(crossings_, [entry](const Crossing& c) { return c.distance < entry; });
    const auto nearest = std::ranges::min_element(crossings_, {}, &Crossing::distance);
    if (nearest != crossings_.end()) stretches_.push_back({window.from, nearest->wall});
  }

  double beyond(const Segment* wall, Vec2 way) const {
    return wall ? distanceTo(*wall, way) * (1 - kTie) : 0;
  }

  /// Rays come through a flat portal into each stretch in which some of it lies.
  void findStretchesAcross(const Hatch& hatch, Vec2 way) {
    std::ranges::sort(crossings_, {}, &Crossing::distance);
    const double least = beyond(hatch.from, way);
    const double most = distanceTo(*hatch.to, way) * (1 + kTie);
    const Segment* from = nullptr;
    double begin = 0;
    for (const Crossing& crossing : crossings_) {
      if (!crossing.isEntrance && crossing.distance >= least && begin <= most)
        stretches_.push_back({from, crossing.wall});
      from = crossing.wall;
      begin = crossing.distance;
    }
  }

  /// Takes up `stretches_`, which go from one bound to the direction `end`. Between `last` and this
  /// bound there is nothing but vertices in one line with the light. Rays may slip through between
  /// them, but not where a wall goes on behind that has been seen there anyway.
  void goOn(const Window& window, std::size_t last, std::size_t bound, Vec2 end) {
    bool isGap = false;
    for (std::size_t i = last; i < bound; ++i) isGap |= bounds_[i].way != bounds_[i + 1].way;
    seen_.clear();
    bool slips = false;
    for (const Stretch stretch : stretches_) {
      const auto before = std::ranges::find(visible_, stretch, &Visible::stretch);
      const bool goesOn = before != visible_.end();
      seen_.push_back({stretch, goesOn ? before->begin : bounds_[bound].way, end});
      slips |= endsBetween(stretch, last, bound);
      if (goesOn) visible_.erase(before);
    }
    for (const Visible& visible : visible_) slips |= endsBetween(visible.stretch, last, bound);
    if (isGap && slips) addLine(window.sector, unit(bounds_[bound].way));
    for (const Visible& visible : visible_) finish(window, visible);
    visible_.swap(seen_);
  }

  /// Whether one of the walls of a stretch has a vertex at one of the bounds from `last` to
  /// `bound`.
  bool endsBetween(Stretch stretch, std::size_t last, std::size_t bound) const {
    for (std::size_t i = last; i <= bound; ++i)
      for (const Segment* wall : {stretch.from, stretch.to})
        if (wall &&
            (bounds_[i].way == fromLight(wall->p0) || bounds_[i].way == fromLight(wall->p1)))
          return true;
    return false;
  }

  void finish(const Window& window, const Visible& visible) {
    LightCone cone{.sector = window.sector,
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
      usePlanesOf(cone);
      const Hatch hatch = *window.hatch;
      addPlane(cone, *cone.to, {hatch.z, hatch.z, !hatch.isFloor});
      if (cone.from) addPlane(cone, *cone.from, {hatch.z, hatch.z, hatch.isFloor});
      if (isEmpty(cone)) return;
      const Planes planes = keepPlanes();
      cone.firstPlane = planes.first;
      cone.lastPlane = planes.last;
    }
    cones_.cones_.push_back(cone);
    goThroughOpenings(cone, visible);
    goThroughFlats(cone, visible);
  }

  void usePlanesOf(const LightCone& cone) {
    const auto kept = cones_.planesOf(cone);
    planes_.assign(kept.begin(), kept.end());
  }
  Planes keepPlanes() {
    const auto first = static_cast<std::uint32_t>(cones_.planes_.size());
    cones_.planes_.insert(cones_.planes_.end(), planes_.begin(), planes_.end());
    return {first, static_cast<std::uint32_t>(cones_.planes_.size())};
  }

  void goThroughOpenings(const LightCone& cone, const Visible& visible) {
    if (cone.to->lightOpenings.empty() || distanceOf(cone, *cone.to) > reach_) return;
    for (const LightOpening& opening : cone.to->lightOpenings) {
      usePlanesOf(cone);
      addBounds(cone, opening);
      if (isEmpty(cone)) continue;
      windows_.push_back({opening.next, &level_[opening.twin], visible.begin, visible.end,
                          keepPlanes(), cone.isDoubtful || hasHoles(opening), std::nullopt});
    }
  }

  static bool hasHoles(const LightOpening& opening) {
    return !opening.middles.empty() && !planted(PlantedBug::ConeThroughMiddles);
  }

  void goThroughFlats(const LightCone& cone, const Visible& visible) {
    const Sector& sector = level_[cone.sector];
    if (planted(PlantedBug::ConePastFlatPortals)) return;
    if (sector.floor.interface && !sector.floor.parallax)
      goThroughFlat(cone, visible, {sector.floor.z, true, cone.from, cone.to},
                    level_[*sector.floor.interface].lower);
    if (sector.ceiling.interface && !sector.ceiling.parallax)
      goThroughFlat(cone, visible, {sector.ceiling.z, false, cone.from, cone.to},
                    level_[*sector.ceiling.interface].upper);
  }

  void goThroughFlat(const LightCone& cone, const Visible& visible, const Hatch& hatch,
                     const std::vector<SectorId>& members) {
    if (hasSlopeAt(level_, level_[cone.sector], hatch.z)) return forget(members);
    const double before = hatch.isFloor ? light_.z - hatch.z : hatch.z - light_.z;
    if (before < -kPositionSlack) return;
    if (before < kPositionSlack) return forget(members);
    usePlanesOf(cone);
    addPlane(cone, *cone.to, {hatch.z, hatch.z, !hatch.isFloor});
    if (isEmpty(cone)) return;
    const Planes planes = keepPlanes();
    for (const SectorId member : members)
      if (hasSlopeAt(level_, level_[member], hatch.z) || isAboveWall(level_[member]))
        forget({member});
      else
        windows_.push_back(
            {member, nullptr, visible.begin, visible.end, planes, cone.isDoubtful, hatch});
  }

  /// Whether the light stands on a wall, as seen on the map.
  bool isAboveWall(const Sector& sector) const {
    return std::ranges::any_of(level_.segmentsOf(sector), [&](const Segment& wall) {
      return length(fromLight(nearestOnSegment(wall.p0, wall.p1, light_.xy()))) < kPositionSlack;
    });
  }

  /// Of the opening, and of slopes on both sides of it.
  void addBounds(const LightCone& cone, const LightOpening& opening) {
    const Segment& wall = *cone.to;
    const Segment& twin = level_[opening.twin];
    const Sector& sector = level_[cone.sector];
    const Sector& next = level_[opening.next];
    const auto add = [&](double z0, double z1, bool isBelow) {
      addPlane(cone, wall, {z0, z1, isBelow});
    };
    if (std::isfinite(opening.zBottom) && !planted(PlantedBug::ConeThroughSteps))
      add(opening.zBottom, opening.zBottom, true);
    if (std::isfinite(opening.zTop)) add(opening.zTop, opening.zTop, false);
    const auto meets = [](const Flat& flat, const std::optional<Slope>& slope) {
      return !flat.parallax && (slope || flat.interface);
    };
    if (meets(sector.floor, sector.floorSlope)) add(wall.air0.zBottom, wall.air1.zBottom, true);
    if (meets(sector.ceiling, sector.ceilingSlope)) add(wall.air0.zTop, wall.air1.zTop, false);
    if (next.floorSlope && !planted(PlantedBug::ConeThroughWedges))
      add(twin.air1.zBottom, twin.air0.zBottom, true);
    if (next.ceilingSlope) add(twin.air1.zTop, twin.air0.zTop, false);
  }

  /// Metres on the map from the light to what a cone sees of a wall, or of its line.
  double distanceOf(const LightCone& cone, const Segment& wall) const {
    return length(nearestOnSegment(distanceTo(wall, cone.begin) * cone.begin,
                                   distanceTo(wall, cone.end) * cone.end, {0, 0}));
  }

  /// A straight line along a wall.
  struct Edge {
    double z0;  ///< at the wall's p0
    double z1;
    bool isBelow;  ///< rays go above it
  };

  void addPlane(const LightCone& cone, const Segment& wall, const Edge& edge) {
    const Vec2 a = fromLight(wall.p0);
    const Vec2 b = fromLight(wall.p1);
    const double h0 = edge.z0 - light_.z;
    const double h1 = edge.z1 - light_.z;
    const Vec2 gradient = (1 / cross(a, b)) * Vec2{h0 * b.y - h1 * a.y, h1 * a.x - h0 * b.x};
    const double size = std::max(
        {largestCoordinate(light_), std::abs(edge.z0), std::abs(edge.z1), length(a), length(b)});
    const HeightPlane plane{
        gradient, edge.isBelow,
        (2 * kArrival + roundingOf(size)) / distanceOf(cone, wall) + roundingOf(length(gradient))};
    for (const HeightPlane& other : planes_)
      if (isHidden(plane, other, cone)) return;
    std::erase_if(planes_, [&](const HeightPlane& other) { return isHidden(other, plane, cone); });
    planes_.push_back(plane);
  }

  /// Whether one plane bounds nothing that the other does not, all over the cone.
  static bool isHidden(const HeightPlane& plane, const HeightPlane& by, const LightCone& cone) {
    if (plane.isBelow != by.isBelow) return false;
    if (plane.gradient == by.gradient) return plane.slackPerMetre <= by.slackPerMetre;
    const Vec2 further = (plane.isBelow ? 1 : -1) * (by.gradient - plane.gradient);
    const double least = plane.slackPerMetre + by.slackPerMetre;
    return dot(further, cone.begin) >= least && dot(further, cone.end) >= least;
  }

  /// Whether nothing of the cone is left between what bounds it below and above.
  bool isEmpty(const LightCone& cone) const {
    for (const HeightPlane& low : planes_)
      for (const HeightPlane& high : planes_) {
        if (!low.isBelow || high.isBelow) continue;
        const Vec2 room = high.gradient - low.gradient;
        const double most = -low.slackPerMetre - high.slackPerMetre;
        if (dot(room, cone.begin) < most && dot(room, cone.end) < most) return true;
      }
    return false;
  }

  /// A direction in which rounding decides which walls rays meet: whatever they can come to from
  /// the sector on is doubtful along it.
  void addLine(SectorId from, Vec2 way) {
    std::vector<SectorId> sectors{from};
    const auto goTo = [&](SectorId sector) { sectors.push_back(sector); };
    while (!sectors.empty()) {
      const SectorId id = sectors.back();
      sectors.pop_back();
      if (!lines_.insert({id.value, way.x, way.y}).second) continue;
      cones_.cones_.push_back({id, nullptr, nullptr, way, way, way, way, 0, 0, true});
      for (const Segment& wall : level_.segmentsOf(level_[id]))
        if (!wall.lightOpenings.empty() && touches(wall, way))
          for (const LightOpening& opening : wall.lightOpenings) goTo(opening.next);
      forEachBehindFlats(id, goTo);
    }
  }

  /// Whether a line from the light comes to the wall, perhaps, and it does not clearly face away.
  bool touches(const Segment& wall, Vec2 way) const {
    const Vec2 a = fromLight(wall.p0);
    const Vec2 b = fromLight(wall.p1);
    const double far = std::max(length(a), length(b));
    const double narrow = 4 * kNarrow * far;
    return cross(a, b) >= -narrow * far && cross(a, way) >= -narrow && cross(way, b) >= -narrow &&
           std::max(dot(a, way), dot(b, way)) > 0;
  }

  template <typename Visit>
  void forEachBehindFlats(SectorId id, Visit&& visit) const {
    const Sector& sector = level_[id];
    if (sector.floor.interface) std::ranges::for_each(level_[*sector.floor.interface].lower, visit);
    if (sector.ceiling.interface)
      std::ranges::for_each(level_[*sector.ceiling.interface].upper, visit);
  }

  /// Says nothing of sectors any more, and of what rays can come to from there.
  void forget(std::vector<SectorId> sectors) {
    const auto goTo = [&](SectorId sector) { sectors.push_back(sector); };
    while (!sectors.empty()) {
      const SectorId id = sectors.back();
      sectors.pop_back();
      if (!cones_.unknown_.insert(id.value).second) continue;
      forEachBehindFlats(id, goTo);
      for (const Segment& wall : level_.segmentsOf(level_[id])) {
        const Vec2 a = fromLight(wall.p0);
        const Vec2 b = fromLight(wall.p1);
        if (cross(a, b) < -kNarrow * length(a) * length(b)) continue;
        for (const LightOpening& opening : wall.lightOpenings) goTo(opening.next);
      }
    }
  }

  struct Crossing {
    double distance;
    const Segment* wall;
    bool isEntrance;
  };

  const Level& level_;
  double reach_;
  LightCones& cones_;
  Vec3 light_;
  std::vector<Window> windows_;  ///< still to visit
  // Of the window at hand:
  std::vector<Part> parts_;
  std::vector<Bound> bounds_;
  std::vector<const Part*> active_;
  std::vector<Crossing> crossings_;
  std::vector<Stretch> stretches_;
  std::vector<Visible> visible_;
  std::vector<Visible> seen_;
  std::vector<HeightPlane> planes_;
  std::set<std::tuple<std::uint32_t, double, double>> lines_;
};

LightCones::LightCones(const Level& level, const Raytracer::Source& light, double reach)
    : level_(level), light_(light) {
  Finder(level, reach, *this).find();
  for (std::size_t i = 0; i < cones_.size(); ++i)
    ++rangeOf_.try_emplace(cones_[i].sector.value, Range{i, 0}).first->second.count;
}

LightCones::Points LightCones::seen(std::span<const Vec3> corners) const {
  Points points;
  for (const Vec3 p : corners) {
    const Vec3 way = p - light_.position;
    points.ways[points.count++] = way;
    points.reach = std::max(points.reach, std::abs(way.x) + std::abs(way.y) + std::abs(way.z));
  }
  points.noise = roundingOf(largestCoordinate(light_.position) + points.reach);
  points.margin = 2 * kArrival + kNarrow * points.reach + points.noise;
  return points;
}

bool LightCones::knows(SectorId sector, const Plane& plane, const Points& points) const {
  return isComplete_ && !unknown_.contains(sector.value) &&
         plane.inFront(light_.position) >= leastInFront(points) && areClear(level_[sector], points);
}

/// Whether no slope of the sector, nor what is opposite it, stops a ray before its target.
bool LightCones::areClear(const Sector& sector, const Points& points) const {
  if (!sector.floorSlope && !sector.ceilingSlope) return true;
  const auto isClear = [&](double ofLight, double ofTarget) {
    return ofTarget > points.margin ||
           (ofTarget >= -points.noise && ofLight >= leastInFront(points));
  };
  const auto areClearOf = [&](auto&& inFront) {
    const double ofLight = inFront(light_.position);
    return std::ranges::all_of(std::span(points.ways).first(points.count), [&](Vec3 way) {
      return isClear(ofLight, inFront(light_.position + way));
    });
  };
  const auto aboveFloor = [&](Vec3 p) { return p.z - sector.airBottom(p.xy()); };
  const auto belowCeiling = [&](Vec3 p) { return sector.airTop(p.xy()) - p.z; };
  return (sector.floor.parallax || areClearOf(aboveFloor)) &&
         (sector.ceiling.parallax || areClearOf(belowCeiling));
}

/// Metres that the light must be in front of a plane, to be sure that rounding stops no ray before
/// it gets to points there.
double LightCones::leastInFront(const Points& points) const {
  return 4 * points.noise * points.reach / kArrival;
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
  for (const HeightPlane& plane : planesOf(cone)) {
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
  const auto ofSector = std::span(cones_).subspan(range->second.first, range->second.count);
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
