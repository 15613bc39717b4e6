#include "light/lit_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "light/continuations.h"
#include "light/grids.h"
#include "light/upright_air.h"
#include "light/vertex_fan.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

using Polygon = std::vector<Vec2>;

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
    joinContinuations(level_, fan_, upright_, lit_);
    return std::move(lit_);
  }

 private:
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
    UprightOutline air = uprightAir(level_, surface);
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

  const Level& level_;
  double texel_;
  VertexFan fan_;
  std::vector<TexelGrid> wallGrids_;
  std::vector<TexelGrid> floorGrids_;
  std::vector<TexelGrid> ceilingGrids_;
  LitSurfaces lit_;
  std::vector<std::vector<UprightSurface>> upright_;
};

/// A cheap bound: to the upright box round a segment, by the longer of its two coordinates.
double distanceToBox(Vec2 a, Vec2 b, Vec2 p) {
  const double x = std::max(std::min(a.x, b.x) - p.x, p.x - std::max(a.x, b.x));
  const double y = std::max(std::min(a.y, b.y) - p.y, p.y - std::max(a.y, b.y));
  return std::max(x, y);
}

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

std::vector<LitSurface::Stretch> LitSurface::insideAlong(double row, double margin) const {
  // Between what lies beside edges, all is inside or all is outside.
  std::vector<Stretch> beside;
  for (const Polygon& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i];
      const Vec2 b = outline[(i + 1) % outline.size()];
      const double low = std::max(std::min(a.y, b.y), row - margin);
      const double high = std::min(std::max(a.y, b.y), row + margin);
      if (low > high) continue;
      const auto xAt = [&](double y) {
        return a.y == b.y ? a.x : std::lerp(a.x, b.x, (y - a.y) / (b.y - a.y));
      };
      const double ends[] = {xAt(low), a.y == b.y ? b.x : xAt(high)};
      beside.push_back({std::min(ends[0], ends[1]) - margin, std::max(ends[0], ends[1]) + margin});
    }
  std::ranges::sort(beside, {}, &Stretch::from);
  std::vector<Stretch> inside;
  for (std::size_t i = 0; i + 1 < beside.size(); ++i) {
    beside[i + 1].to = std::max(beside[i + 1].to, beside[i].to);
    const Stretch between{beside[i].to, beside[i + 1].from};
    if (between.from < between.to && contains({(between.from + between.to) / 2, row}))
      inside.push_back(between);
  }
  return inside;
}

Vec2 LitSurface::nearest(Vec2 p) const {
  Vec2 best = outlines.front().front();
  double distance = std::numeric_limits<double>::infinity();
  for (const Polygon& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i];
      const Vec2 b = outline[(i + 1) % outline.size()];
      if (distanceToBox(a, b, p) > distance) continue;
      const Vec2 q = nearestOnSegment(a, b, p);
      const double found = length(q - p);
      if (found < distance) best = q, distance = found;
    }
  return best;
}

std::vector<LitSurface::Edge> LitSurface::edgesWithin(Vec2 p, double reach) const {
  std::vector<Edge> edges;
  for (const Polygon& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Edge edge{outline[i], outline[(i + 1) % outline.size()]};
      if (distanceToBox(edge.a, edge.b, p) <= reach &&
          length(nearestOnSegment(edge.a, edge.b, p) - p) <= reach)
        edges.push_back(edge);
    }
  return edges;
}

LitSurfaces makeLitSurfaces(const Level& level, double texel) {
  return LitSurfaceBuilder(level, texel).build();
}

}  // namespace hearth
