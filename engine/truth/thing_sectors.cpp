#include "truth/thing_sectors.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "level/locate.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth {

namespace {

/// Metres. What is no farther apart touches.
constexpr double kTouch = kPositionSlack;
/// m^2. An opening is larger: what rounding leaves open between two slopes that touch is none.
constexpr double kLeastOpening = 1e-9;

/// All points p with dot(normal, p) <= reach.
struct HalfSpace {
  Vec3 normal;
  double reach;

  double excess(Vec3 p) const { return dot(normal, p) - reach; }
};

HalfSpace below(double z) { return {{0, 0, 1}, z}; }
HalfSpace below(const Slope& slope) {
  const Vec2 g = slope.gradient;
  return {{-g.x, -g.y, 1}, slope.zAt({0, 0})};
}
HalfSpace opposite(const HalfSpace& space) { return {-1 * space.normal, -space.reach}; }
HalfSpace above(double z) { return opposite(below(z)); }
HalfSpace above(const Slope& slope) { return opposite(below(slope)); }

/// What of a polygon lies in a half-space, or no more than `slack` outside (Sutherland, Hodgman).
Polygon clipped(const Polygon& polygon, const HalfSpace& space, double slack) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i];
    const Vec3 b = polygon[(i + 1) % polygon.size()];
    const double outA = space.excess(a) - slack;
    const double outB = space.excess(b) - slack;
    if (outA <= 0) kept.push_back(a);
    if ((outA < 0 && outB > 0) || (outA > 0 && outB < 0))
      kept.push_back(a + outA / (outA - outB) * (b - a));
  }
  return kept;
}

Polygon clipped(Polygon polygon, const std::vector<HalfSpace>& spaces, double slack) {
  // Most polygons lie far from most openings.
  for (const HalfSpace& space : spaces)
    if (std::ranges::all_of(polygon, [&](Vec3 p) { return space.excess(p) > slack; })) return {};
  for (const HalfSpace& space : spaces) polygon = clipped(polygon, space, slack);
  return polygon;
}

double area(const Polygon& polygon) {
  Vec3 twice;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice = twice + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return length(twice) / 2;
}

// ---- through walls

/// What bounds a sector's air below and above.
std::vector<HalfSpace> flatsOf(const Sector& sector) {
  std::vector<HalfSpace> flats{above(sector.floor.z), below(sector.ceiling.z)};
  if (sector.floorSlope) flats.push_back(above(*sector.floorSlope));
  if (sector.ceilingSlope) flats.push_back(below(*sector.ceilingSlope));
  return flats;
}

/// The part of a segment in which the airs of its two sides meet, between two heights.
struct Gap {
  SectorId next;
  double zBottom;
  double zTop;
};

std::vector<Gap> gapsOf(const Level& level, const Segment& segment) {
  const Sector& sector = level[segment.sector];
  if (const Portal* portal = std::get_if<Portal>(&segment.wall))
    return {{portal->next, sector.floor.z, sector.ceiling.z}};
  std::vector<Gap> gaps;
  if (const Stack* stack = std::get_if<Stack>(&segment.wall)) {
    double zBottom = sector.floor.z;
    for (std::size_t i = 0; i < stack->subWalls.size(); ++i) {
      const double zTop = stack->topOf(i, sector.floor.z, sector.ceiling.z);
      if (const Portal* portal = std::get_if<Portal>(&stack->subWalls[i].kind))
        gaps.push_back({portal->next, zBottom, zTop});
      zBottom = zTop;
    }
  }
  return gaps;
}

/// The half-spaces whose common part is the opening in a gap. None if it is closed.
std::optional<std::vector<HalfSpace>> openingIn(const Level& level, const Segment& segment,
                                                const Gap& gap) {
  std::vector<HalfSpace> spaces{above(gap.zBottom), below(gap.zTop)};
  for (const SectorId side : {segment.sector, gap.next})
    std::ranges::copy(flatsOf(level[side]), std::back_inserter(spaces));
  const auto raised = [](Vec2 p, double z) { return Vec3{p.x, p.y, z}; };
  const Polygon wall{raised(segment.p0, gap.zBottom), raised(segment.p1, gap.zBottom),
                     raised(segment.p1, gap.zTop), raised(segment.p0, gap.zTop)};
  if (area(clipped(wall, spaces, 0)) < kLeastOpening) return std::nullopt;

  const Vec2 along = unit(segment.p1 - segment.p0);
  const Vec2 across = turned90(along);
  const auto upTo = [](Vec2 direction, Vec2 p) {
    return HalfSpace{{direction.x, direction.y, 0}, dot(direction, p)};
  };
  for (const HalfSpace& space : {upTo(along, segment.p1), opposite(upTo(along, segment.p0)),
                                 upTo(across, segment.p0), opposite(upTo(across, segment.p0))})
    spaces.push_back(space);
  return spaces;
}

bool crosses(const Level& level, const std::vector<Polygon>& thing, const Segment& segment,
             const Gap& gap) {
  const auto opening = openingIn(level, segment, gap);
  return opening && std::ranges::any_of(thing, [&](const Polygon& polygon) {
           return !clipped(polygon, *opening, kTouch).empty();
         });
}

// ---- through flat portals

/// A convex outline on the map, or what a line makes of one.
using Outline = std::vector<Vec2>;

struct Edge {
  Vec2 a;
  Vec2 b;
};

std::vector<Edge> edgesOf(const Outline& outline) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < outline.size(); ++i)
    edges.push_back({outline[i], outline[(i + 1) % outline.size()]});
  return edges;
}

/// Whether the point lies in the outline or no more than kTouch outside.
bool touches(const Outline& outline, Vec2 p) {
  bool isBefore = false;  // any of the edges; or behind one
  bool isBehind = false;
  for (const Edge& edge : edgesOf(outline)) {
    const Vec2 nearest = edge.a == edge.b ? edge.a : nearestOnSegment(edge.a, edge.b, p);
    if (length(p - nearest) <= kTouch) return true;
    if (edge.a == edge.b) continue;
    const int side = orientation(edge.a, edge.b, p);
    isBefore |= side >= 0;
    isBehind |= side <= 0;
  }
  return isBefore != isBehind;
}

std::vector<Edge> edgesOf(const Level& level, SectorId sector) {
  std::vector<Edge> edges;
  for (const Segment& segment : level.segmentsOf(level[sector]))
    edges.push_back({segment.p0, segment.p1});
  return edges;
}

/// Where the lines of two edges cross, if they are not parallel.
std::optional<Vec2> crossing(const Edge& e, const Edge& f) {
  const Vec2 along = e.b - e.a;
  const double speed = cross(along, f.b - f.a);
  if (speed == 0) return std::nullopt;
  return e.a + cross(f.a - e.a, f.b - f.a) / speed * along;
}

/// The vertices of several outlines, and all points at which the lines of their edges cross: what
/// their outlines have in common, if anything, has a corner in one of these.
std::vector<Vec2> cornersAmong(const std::vector<Edge>& edges) {
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    corners.push_back(edges[i].a);
    for (std::size_t k = 0; k < i; ++k)
      if (const auto found = crossing(edges[i], edges[k])) corners.push_back(*found);
  }
  return corners;
}

/// Whether beside `p`, at least, both sectors have air: a common edge is no way through. Looks in
/// no direction in which walls tend to run.
bool overlapBeside(const Level& level, SectorId a, SectorId b, Vec2 p) {
  constexpr int kDirections = 64;
  constexpr double kBeside = 4 * kTouch;
  for (int i = 0; i < kDirections; ++i) {
    const SinCos turn = sinCosDegrees(360 * (i + 0.5) / kDirections);
    const Vec2 beside = p + kBeside * Vec2{turn.cos, turn.sin};
    if (contains(level, level[a], beside) && contains(level, level[b], beside)) return true;
  }
  return false;
}

/// Whether two sectors on either side of a flat portal have air in common in an outline.
bool overlapIn(const Level& level, const Outline& outline, SectorId a, SectorId b) {
  std::vector<Edge> edges = edgesOf(outline);
  for (const SectorId side : {a, b})
    std::ranges::copy(edgesOf(level, side), std::back_inserter(edges));
  return std::ranges::any_of(cornersAmong(edges), [&](Vec2 p) {
    return touches(outline, p) && overlapBeside(level, a, b, p);
  });
}

/// The members of the other side of a flat portal to which a sector leads where the thing is.
std::vector<SectorId> acrossFlat(const Level& level, const std::vector<Polygon>& thing,
                                 SectorId sector, FlatPortalId id, FlatPortalSide to) {
  const FlatPortal& flatPortal = level[id];
  std::vector<Outline> cuts;  // of the thing, in the portal's plane
  for (const Polygon& polygon : thing) {
    const Polygon cut = clipped(polygon, {above(flatPortal.z), below(flatPortal.z)}, kTouch);
    if (cut.empty()) continue;
    Outline& outline = cuts.emplace_back();
    for (const Vec3 p : cut) outline.push_back(p.xy());
  }
  std::vector<SectorId> reached;
  for (const SectorId member : flatPortal.members(to))
    if (std::ranges::any_of(
            cuts, [&](const Outline& cut) { return overlapIn(level, cut, sector, member); }))
      reached.push_back(member);
  return reached;
}

std::vector<SectorId> reachedFrom(const Level& level, const std::vector<Polygon>& thing,
                                  SectorId id) {
  std::vector<SectorId> reached;
  const Sector& sector = level[id];
  for (const Segment& segment : level.segmentsOf(sector))
    for (const Gap& gap : gapsOf(level, segment))
      if (crosses(level, thing, segment, gap)) reached.push_back(gap.next);
  const auto add = [&](const Flat& flat, FlatPortalSide to) {
    if (flat.flatPortal)
      std::ranges::copy(acrossFlat(level, thing, id, *flat.flatPortal, to),
                        std::back_inserter(reached));
  };
  add(sector.floor, FlatPortalSide::Lower);
  add(sector.ceiling, FlatPortalSide::Upper);
  return reached;
}

}  // namespace

std::vector<bool> sectorsCrossedBy(const Level& level, SectorId sector,
                                   const std::vector<Polygon>& thing) {
  std::vector<bool> isIn(level.sectors.size());
  std::vector<SectorId> toVisit{sector};
  while (!toVisit.empty()) {
    const SectorId id = toVisit.back();
    toVisit.pop_back();
    if (isIn[id.index()]) continue;
    isIn[id.index()] = true;
    std::ranges::copy(reachedFrom(level, thing, id), std::back_inserter(toVisit));
  }
  return isIn;
}

}  // namespace hearth
