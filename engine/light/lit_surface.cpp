#include "light/lit_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "light/grid/continuations.h"
#include "light/grid/grids.h"
#include "light/grid/upright_air.h"
#include "light/grid/vertex_fan.h"
#include "math/check.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

using Polygon = std::vector<Vec2>;

class LitSurfaceBuilder {
 public:
  LitSurfaceBuilder(const Scene& scene, double texel)
      : scene_(scene),
        texel_(texel),
        fan_(scene),
        wallGrids_(wallGrids(scene.level(), fan_, texel)),
        floorGrids_(slopeGrids(scene, true, texel)),
        ceilingGrids_(slopeGrids(scene, false, texel)),
        lit_(scene.level().surfaces.size()),
        upright_(scene.level().segments.size()) {}

  LitSurfaces build() {
    for (std::size_t i = 0; i < lit_.size(); ++i) {
      const SurfaceId id(i);
      const SurfaceKind kind = scene_[id].kind;
      if (isSky(kind) || isThing(kind) || !scene_.geometryOf(id).shows) continue;
      if (isUpright(kind))
        addUpright(id);
      else
        addHorizontal(id);
    }
    joinContinuations(scene_, fan_, upright_, lit_);
    return std::move(lit_);
  }

 private:
  void add(SurfaceId id, const TexelGrid& grid, Vec3 anchor, Vec3 normal,
           std::span<const Polygon> outlines) {
    LitSurface& lit = lit_[id.index()].emplace();
    lit.grid = grid;
    lit.anchor = anchor;
    lit.normal = normal;
    lit.texels = texelsAround(outlines);
    lit.outline = Polygons(outlines);
  }

  void addUpright(SurfaceId id) {
    UprightOutline air = uprightAir(scene_, id);
    if (air.size() < 3) return;
    const Segment& segment = scene_[*scene_[id].segment];
    const TexelGrid& grid = wallGrids_[segment.id.index()];
    Polygon outline;
    outline.reserve(air.size());
    for (const Vec2 p : air) {
      const Vec2 xy = lerp(segment.p0, segment.p1, p.x);
      outline.push_back(grid.toTexels({xy.x, xy.y, p.y}));
    }
    const Vec2 inward = (1 / segment.length) * turned90(segment.p1 - segment.p0);
    add(id, grid, {segment.p0.x, segment.p0.y, 0}, {inward.x, inward.y, 0}, {&outline, 1});
    upright_[segment.id.index()].push_back({id, std::move(air)});
  }

  void addHorizontal(SurfaceId id) {
    const Surface& surface = scene_[id];
    const Sector& sector = scene_[surface.sector];
    const double sign = facesDown(surface.kind) ? -1 : 1;
    if (isLevelFlat(surface.kind)) {
      const double z = scene_.geometryOf(id).zBottom;
      const TexelGrid grid = flatGrid(z, texel_);
      add(id, grid, {0, 0, z}, {0, 0, sign}, outlinesOf(sector, grid, [&](Vec2) { return z; }));
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
      outline.reserve(loop.count);
      for (std::size_t i = 0; i < loop.count; ++i) {
        const Vec2 p = scene_[SegmentId(loop.first.index() + i)].p0;
        outline.push_back(grid.toTexels({p.x, p.y, zAt(p)}));
      }
    }
    return outlines;
  }

  Scene scene_;
  double texel_;
  VertexFan fan_;
  std::vector<TexelGrid> wallGrids_;
  std::vector<TexelGrid> floorGrids_;
  std::vector<TexelGrid> ceilingGrids_;
  LitSurfaces lit_;
  std::vector<std::vector<UprightSurface>> upright_;
};

}  // namespace

TexelRect texelsAround(std::span<const std::vector<Vec2>> outlines) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  Vec2 low = {kEndless, kEndless};
  Vec2 high = {-kEndless, -kEndless};
  for (const std::vector<Vec2>& outline : outlines)
    for (const Vec2 p : outline) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  // Bilinear filtering at p reads texels floor(p - 1/2) and the one after it. A whisker more, so
  // that a point on the edge may be rounded outwards.
  const auto first = [](double p) { return static_cast<int>(std::floor(p - 0.5 - kFilterSlack)); };
  const auto last = [](double p) {
    return static_cast<int>(std::floor(p - 0.5 + kFilterSlack)) + 1;
  };
  const int i0 = first(low.x);
  const int j0 = first(low.y);
  return {i0, j0, last(high.x) - i0 + 1, last(high.y) - j0 + 1};
}

TexelRect intersection(const TexelRect& a, const TexelRect& b) {
  const int i0 = std::max(a.i0, b.i0);
  const int j0 = std::max(a.j0, b.j0);
  const TexelRect both{i0, j0, std::min(a.i0 + a.width, b.i0 + b.width) - i0,
                       std::min(a.j0 + a.height, b.j0 + b.height) - j0};
  CHECK(both.width > 0 && both.height > 0, both.i0, both.j0, both.width, both.height);
  return both;
}

ListPerRow<LitSurface::TexelRun> LitSurface::usedRuns(int firstRow, int rows) const {
  // See texelsAround: the middles of texels that are used are less than one texel off. Another
  // whisker, so that no rounding leaves a row of its texels without one.
  const auto near = outline.nearAlongRows(firstRow + 0.5, rows, 1 + 2 * kFilterSlack);
  ListPerRow<TexelRun> used;
  for (int row = 0; row < rows; ++row) {
    used.addRow();
    std::optional<TexelRun> run;
    for (const auto& [from, to] : near.row(row)) {
      const TexelRun next{
          std::max(texels.i0, static_cast<int>(std::ceil(from - 0.5))),
          std::min(texels.i0 + texels.width - 1, static_cast<int>(std::floor(to - 0.5)))};
      if (next.first > next.last) continue;
      const bool isJoined = run && next.first <= run->last + 1;
      if (run && !isJoined) used.add(*run);
      run = {isJoined ? run->first : next.first, next.last};
    }
    CHECK(run.has_value(), firstRow + row, texels.j0, texels.height);
    used.add(*run);
  }
  return used;
}

LitSurfaces makeLitSurfaces(const Scene& scene, double texel) {
  return LitSurfaceBuilder(scene, texel).build();
}

}  // namespace hearth
