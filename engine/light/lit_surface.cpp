#include "light/lit_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "level/openings.h"
#include "light/grids.h"
#include "light/vertex_fan.h"
#include "math/planted_bug.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// z over a segment: one height at p0 and one at p1.
struct Line {
  double at0;
  double at1;
};

using Polygon = std::vector<Vec2>;

/// The part of a convex polygon in (share, z) that lies above the line (below it for `sign` -1).
Polygon clipped(const Polygon& polygon, Line line, double sign) {
  const auto height = [&](Vec2 p) { return sign * (p.y - std::lerp(line.at0, line.at1, p.x)); };
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    const double ha = height(a);
    const double hb = height(b);
    if (ha >= 0) kept.push_back(a);
    if ((ha > 0 && hb < 0) || (ha < 0 && hb > 0)) kept.push_back(lerp(a, b, ha / (ha - hb)));
  }
  return kept;
}

/// The part of an upright surface that bounds air, in (share of the segment, z). Convex, because
/// what limits it from below is a maximum of lines and from above a minimum.
Polygon uprightAir(const Level& level, const Surface& surface) {
  const Segment& segment = level[*surface.segment];
  Polygon air = {{0, surface.zBottom}, {1, surface.zBottom}, {1, surface.zTop}, {0, surface.zTop}};
  air = clipped(air, {segment.air0.zBottom, segment.air1.zBottom}, 1);
  air = clipped(air, {segment.air0.zTop, segment.air1.zTop}, -1);
  if (planted(PlantedBug::StackPieceLitOverWholeWall) && surface.kind == SurfaceKind::StackSolid)
    for (Vec2& p : air) p.y = p.y == surface.zTop ? level[surface.sector].ceiling.z : p.y;
  if (!isSidewall(surface.kind)) return air;
  for (const WallPiece& piece : segment.pieces) {
    const Opening* opening = std::get_if<Opening>(&piece.content);
    if (!opening || piece.zBottom != surface.zBottom) continue;
    const Segment& twin = level[opening->twin];
    if (surface.kind == SurfaceKind::FloorSidewall)
      return clipped(air, {twin.air1.zBottom, twin.air0.zBottom}, -1);
    return clipped(air, {twin.air1.zTop, twin.air0.zTop}, 1);
  }
  return air;
}

TexelRect texelsOf(const std::vector<Polygon>& outlines) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  Vec2 low = {kEndless, kEndless};
  Vec2 high = {-kEndless, -kEndless};
  for (const Polygon& outline : outlines)
    for (const Vec2 p : outline) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  // Bilinear filtering at p reads texels floor(p - 1/2) and the one after it. A whisker more, so
  // that a point on the edge may be rounded outwards.
  constexpr double kWhisker = 1e-6;
  const auto first = [](double p) { return static_cast<int>(std::floor(p - 0.5 - kWhisker)); };
  const auto last = [](double p) { return static_cast<int>(std::floor(p - 0.5 + kWhisker)) + 1; };
  const int i0 = first(low.x);
  const int j0 = first(low.y);
  return {i0, j0, last(high.x) - i0 + 1, last(high.y) - j0 + 1};
}

class LitSurfaceBuilder {
 public:
  LitSurfaceBuilder(const Level& level, double texel)
      : level_(level),
        texel_(texel),
        fan_(level),
        wallGrids_(wallGrids(level, fan_, texel)),
        floorGrids_(slopeGrids(level, true, texel)),
        ceilingGrids_(slopeGrids(level, false, texel)),
        lit_(level.surfaces.size()),
        upright_(level.segments.size()) {}

  LitSurfaces build() {
    for (std::size_t i = 0; i < level_.surfaces.size(); ++i) {
      const Surface& surface = level_.surfaces[i];
      if (isSky(surface.kind)) continue;
      if (isUpright(surface.kind))
        addUpright(SurfaceId(i), surface);
      else
        addHorizontal(SurfaceId(i), surface);
    }
    for (std::size_t i = 0; i < level_.segments.size(); ++i) {
      joinAbove(SegmentId(i));
      joinAcrossFlatPortals(SegmentId(i));
      joinAfter(SegmentId(i));
      joinFlats(level_.segments[i], true);
      joinFlats(level_.segments[i], false);
    }
    return std::move(lit_);
  }

 private:
  /// An upright surface with its outline in (share, z), for finding common edges.
  struct Upright {
    SurfaceId id;
    Polygon air;
  };

  void add(SurfaceId id, const TexelGrid& grid, Vec3 anchor, Vec3 normal,
           std::vector<Polygon> outlines) {
    LitSurface& lit = lit_[id.index()].emplace();
    lit.grid = grid;
    lit.anchor = anchor;
    lit.normal = normal;
    lit.texels = texelsOf(outlines);
    lit.outlines = std::move(outlines);
  }

  void addUpright(SurfaceId id, const Surface& surface) {
    Polygon air = uprightAir(level_, surface);
    if (air.size() < 3) return;
    const Segment& segment = level_[*surface.segment];
    const TexelGrid& grid = wallGrids_[surface.segment->index()];
    Polygon outline;
    for (const Vec2 p : air) {
      const Vec2 xy = lerp(segment.p0, segment.p1, p.x);
      outline.push_back(grid.toTexels({xy.x, xy.y, p.y}));
    }
    const Vec2 inward = (1 / segment.length) * turned90(segment.p1 - segment.p0);
    add(id, grid, {segment.p0.x, segment.p0.y, 0}, {inward.x, inward.y, 0}, {std::move(outline)});
    upright_[surface.segment->index()].push_back({id, std::move(air)});
  }

  void addHorizontal(SurfaceId id, const Surface& surface) {
    const Sector& sector = level_[surface.sector];
    const double sign = isOverhead(surface.kind) ? -1 : 1;
    if (isFlat(surface.kind)) {
      add(id, flatGrid(surface.zBottom, texel_), {0, 0, surface.zBottom}, {0, 0, sign},
          outlinesOf(sector, flatGrid(surface.zBottom, texel_),
                     [&](Vec2) { return surface.zBottom; }));
      return;
    }
    const bool floor = surface.kind == SurfaceKind::SlopeFloor;
    const Slope& slope = floor ? *sector.floorSlope : *sector.ceilingSlope;
    const TexelGrid& grid = (floor ? floorGrids_ : ceilingGrids_)[surface.sector.index()];
    const double steep = sign / std::sqrt(1 + dot(slope.gradient, slope.gradient));
    add(id, grid, {slope.origin.x, slope.origin.y, slope.zAt0},
        {-slope.gradient.x * steep, -slope.gradient.y * steep, steep},
        outlinesOf(sector, grid, [&](Vec2 p) { return slope.zAt(p); }));
  }

  template <typename HeightAt>
  std::vector<Polygon> outlinesOf(const Sector& sector, const TexelGrid& grid,
                                  HeightAt&& zAt) const {
    std::vector<Polygon> outlines;
    for (const Loop& loop : sector.loops) {
      Polygon& outline = outlines.emplace_back();
      for (std::size_t i = 0; i < loop.count; ++i) {
        const Vec2 p = level_.segments[loop.first.index() + i].p0;
        outline.push_back(grid.toTexels({p.x, p.y, zAt(p)}));
      }
    }
    return outlines;
  }

  void join(SurfaceId a, SurfaceId b, Vec2 edge0, Vec2 edge1) {
    lit_[a.index()]->continuations.push_back({b, edge0, edge1});
    lit_[b.index()]->continuations.push_back({a, edge0, edge1});
  }

  /// Joins the surfaces of one segment that stand on one another.
  void joinAbove(SegmentId id) {
    const std::vector<Upright>& walls = upright_[id.index()];
    for (std::size_t i = 0; i < walls.size(); ++i)
      for (std::size_t k = i + 1; k < walls.size(); ++k)
        if (const auto edge = commonEdge(walls[i].air, walls[k].air))
          join(walls[i].id, walls[k].id, onGrid(id, edge->first), onGrid(id, edge->second));
  }

  /// Joins the surfaces of this segment to those of the walls that go on below a flat portal.
  void joinAcrossFlatPortals(SegmentId id) {
    const Sector& sector = level_[level_[id].sector];
    if (!sector.floor.interface) return;
    for (const SegmentId below : fan_.acrossFlatPortals(id)) {
      const Sector& other = level_[level_[below].sector];
      if (other.ceiling.interface != sector.floor.interface) continue;
      for (const Upright& a : upright_[id.index()])
        for (const Upright& b : upright_[below.index()])
          if (const auto edge = commonEdge(a.air, b.air))
            join(a.id, b.id, onGrid(id, edge->first), onGrid(id, edge->second));
    }
  }

  /// A point of a segment's plane, given as (share, z), in texel coordinates.
  Vec2 onGrid(SegmentId id, Vec2 p) const {
    const Vec2 xy = lerp(level_[id].p0, level_[id].p1, p.x);
    return wallGrids_[id.index()].toTexels({xy.x, xy.y, p.y});
  }

  /// The ends of what convex polygons that do not overlap have in common, if that has a length.
  static std::optional<std::pair<Vec2, Vec2>> commonEdge(const Polygon& a, const Polygon& b) {
    Polygon common;
    const auto gather = [&](const Polygon& from, const Polygon& to) {
      for (const Vec2 p : from)
        for (std::size_t i = 0; i < to.size(); ++i)
          if (length(nearestOnSegment(to[i], to[(i + 1) % to.size()], p) - p) <= kHeightNoise)
            common.push_back(p);
    };
    gather(a, b);
    gather(b, a);
    if (common.empty()) return std::nullopt;
    const auto [low, high] = std::ranges::minmax_element(common, lessXY);
    if (length(*high - *low) <= kHeightNoise) return std::nullopt;
    return std::pair(*low, *high);
  }

  /// Joins surfaces of this segment to those of walls that continue it beyond its p1.
  void joinAfter(SegmentId id) {
    const Segment& segment = level_[id];
    for (const VertexFan::Spoke& spoke : fan_.at(segment.p1)) {
      if (!spoke.startsHere || spoke.segment == id || !sameRun(id, spoke.segment)) continue;
      for (const Upright& a : upright_[id.index()])
        for (const Upright& b : upright_[spoke.segment.index()]) {
          const auto [aLow, aHigh] = heightsAt(a.air, 1);
          const auto [bLow, bHigh] = heightsAt(b.air, 0);
          const double low = std::max(aLow, bLow);
          const double high = std::min(aHigh, bHigh);
          if (high - low <= kHeightNoise) continue;
          const Continuation edge{b.id, onGrid(id, {1, low}), onGrid(id, {1, high})};
          // One-way portals let a wall go on only their way.
          const SectorId sectorA = segment.sector;
          const SectorId sectorB = level_[spoke.segment].sector;
          if (fan_.joined(segment.p1, sectorA, sectorB, low, high))
            lit_[a.id.index()]->continuations.push_back(edge);
          if (fan_.joined(segment.p1, sectorB, sectorA, low, high))
            lit_[b.id.index()]->continuations.push_back({a.id, edge.edge0, edge.edge1});
        }
    }
  }

  bool sameRun(SegmentId a, SegmentId b) const {
    return wallGrids_[a.index()] == wallGrids_[b.index()];
  }

  /// The heights that a convex outline in (share, z) covers at one end of the segment.
  static std::pair<double, double> heightsAt(const Polygon& air, double share) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vec2 p : air)
      if (std::abs(p.x - share) <= kHeightNoise)
        low = std::min(low, p.y), high = std::max(high, p.y);
    return {low, high};
  }

  /// Joins floors (ceilings) that are one plane on both sides of an opening.
  void joinFlats(const Segment& segment, bool floor) {
    const std::optional<SurfaceId> mine = flatOf(segment.sector, floor);
    if (!mine) return;
    for (const SectorId next : openAtFoot(level_, segment, floor)) {
      const std::optional<SurfaceId> other = flatOf(next, floor);
      if (!other || *other == *mine || !onePlane(level_[*mine], level_[*other], segment)) continue;
      const Sector& sector = level_[segment.sector];
      const auto onMyGrid = [&](Vec2 p) {
        const double z = floor ? sector.airBottom(p) : sector.airTop(p);
        return lit_[mine->index()]->grid.toTexels({p.x, p.y, z});
      };
      // The other side's own segment says the same the other way round.
      lit_[mine->index()]->continuations.push_back(
          {*other, onMyGrid(segment.p0), onMyGrid(segment.p1)});
    }
  }

  std::optional<SurfaceId> flatOf(SectorId id, bool floor) const {
    const Sector& sector = level_[id];
    const std::optional<SurfaceId> surface = floor ? sector.floorSurface : sector.ceilingSurface;
    return surface && lit_[surface->index()] ? surface : std::nullopt;
  }

  bool onePlane(const Surface& a, const Surface& b, const Segment& along) const {
    if (a.kind != b.kind) return false;
    if (isFlat(a.kind)) return std::abs(a.zBottom - b.zBottom) <= kAuthorNoise;
    const bool floor = a.kind == SurfaceKind::SlopeFloor;
    const std::vector<TexelGrid>& grids = floor ? floorGrids_ : ceilingGrids_;
    if (!(grids[a.sector.index()] == grids[b.sector.index()])) return false;
    const auto slope = [&](const Surface& s) {
      return floor ? *level_[s.sector].floorSlope : *level_[s.sector].ceilingSlope;
    };
    return continueInOnePlane(slope(a), slope(b), along);
  }

  const Level& level_;
  double texel_;
  VertexFan fan_;
  std::vector<TexelGrid> wallGrids_;
  std::vector<TexelGrid> floorGrids_;
  std::vector<TexelGrid> ceilingGrids_;
  LitSurfaces lit_;
  std::vector<std::vector<Upright>> upright_;
};

}  // namespace

Vec3 LitSurface::toWorld(Vec2 texelPoint) const {
  const Vec3 p = grid.toWorld(texelPoint);
  return p - distanceInFront(p) * normal;
}

bool LitSurface::contains(Vec2 p) const {
  bool inside = false;
  for (const Polygon& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i];
      const Vec2 b = outline[(i + 1) % outline.size()];
      if (a == p) return true;
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const int side = orientation(a, b, p);
      if (side == 0) return true;
      if ((side > 0) == (b.y <= p.y)) inside = !inside;
    }
  return inside;
}

Vec2 LitSurface::nearest(Vec2 p) const {
  Vec2 best = outlines.front().front();
  double distance = std::numeric_limits<double>::infinity();
  for (const Polygon& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 q = nearestOnSegment(outline[i], outline[(i + 1) % outline.size()], p);
      const double found = dot(q - p, q - p);
      if (found < distance) best = q, distance = found;
    }
  return best;
}

LitSurfaces makeLitSurfaces(const Level& level, double texel) {
  return LitSurfaceBuilder(level, texel).build();
}

}  // namespace hearth
