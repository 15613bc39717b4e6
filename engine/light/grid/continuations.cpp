#include "light/grid/continuations.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "light/grid/grids.h"
#include "light/grid/open_stretches.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

class Joiner {
 public:
  Joiner(const Scene& scene, const VertexFan& fan,
         const std::vector<std::vector<UprightSurface>>& upright, LitSurfaces& surfaces)
      : scene_(scene), fan_(fan), upright_(upright), lit_(surfaces) {}

  void joinAll() {
    for (std::size_t i = 0; i < scene_.level().segments.size(); ++i) {
      joinAbove(SegmentId(i));
      joinAcrossFlatPortals(SegmentId(i));
      joinAfter(SegmentId(i));
      joinFlats(scene_.level().segments[i], true);
      joinFlats(scene_.level().segments[i], false);
    }
    sortByPlaceInLevel();
  }

 private:
  /// Which of several continuations a sample is on shall not depend on the order of joining.
  void sortByPlaceInLevel() {
    for (std::optional<LitSurface>& surface : lit_)
      if (surface) std::ranges::stable_sort(surface->continuations, {}, &Continuation::surface);
  }

  void join(SurfaceId from, SurfaceId to, Vec2 edge0, Vec2 edge1) {
    lit_[from.index()]->continuations.push_back({to, edge0, edge1});
  }

  void joinBoth(const UprightSurface& a, const UprightSurface& b, std::pair<Vec2, Vec2> edge) {
    join(a.id, b.id, onGrid(a, edge.first), onGrid(a, edge.second));
    join(b.id, a.id, onGrid(a, edge.first), onGrid(a, edge.second));
  }

  /// What hangs in an opening continues only its like, not the wall round it.
  bool areAlike(const UprightSurface& a, const UprightSurface& b) const {
    return (scene_[a.id].kind == SurfaceKind::MaskedMiddle) ==
           (scene_[b.id].kind == SurfaceKind::MaskedMiddle);
  }

  /// Of surfaces of one segment, or of two with the same ends.
  std::optional<std::pair<Vec2, Vec2>> edgeBetween(const UprightSurface& a,
                                                   const UprightSurface& b) const {
    return areAlike(a, b) ? commonEdge(a.air, b.air, wallOf(a).length) : std::nullopt;
  }

  /// Joins the surfaces of one segment that stand on one another.
  void joinAbove(SegmentId id) {
    const std::vector<UprightSurface>& walls = upright_[id.index()];
    for (std::size_t i = 0; i < walls.size(); ++i)
      for (std::size_t k = i + 1; k < walls.size(); ++k)
        if (const auto edge = edgeBetween(walls[i], walls[k])) joinBoth(walls[i], walls[k], *edge);
  }

  /// Joins the surfaces of this segment to those of the walls that go on below a flat portal.
  void joinAcrossFlatPortals(SegmentId id) {
    const Sector& sector = scene_[scene_[id].sector];
    if (!sector.floor.flatPortal) return;
    for (const SegmentId below : fan_.acrossFlatPortals(id)) {
      const Sector& other = scene_[scene_[below].sector];
      if (other.ceiling.flatPortal != sector.floor.flatPortal) continue;
      for (const UprightSurface& a : upright_[id.index()])
        for (const UprightSurface& b : upright_[below.index()])
          if (const auto edge = edgeBetween(a, b)) joinBoth(a, b, *edge);
    }
  }

  /// A point of an upright surface's plane, given as (fraction, z), in texel coordinates.
  Vec2 onGrid(const UprightSurface& wall, Vec2 p) const {
    const Vec2 xy = lerp(wallOf(wall).p0, wallOf(wall).p1, p.x);
    return lit_[wall.id.index()]->grid.toTexels({xy.x, xy.y, p.y});
  }

  /// Joins surfaces of this segment to those of walls that continue it beyond its p1.
  void joinAfter(SegmentId id) {
    for (const VertexFan::Spoke& spoke : fan_.atEndOf(id)) {
      if (!spoke.startsHere || spoke.segment == id) continue;
      for (const UprightSurface& a : upright_[id.index()])
        for (const UprightSurface& b : upright_[spoke.segment.index()])
          if (areAlike(a, b) && onOneGrid(a.id, b.id)) joinAtVertex(a, b, scene_[id].p1);
    }
  }

  /// `a` ends at the vertex where `b` begins. One-way portals let a wall go on only their way.
  void joinAtVertex(const UprightSurface& a, const UprightSurface& b, Vec2 vertex) {
    const auto [aLow, aHigh] = heightsAt(a.air, 1, wallOf(a).length);
    const auto [bLow, bHigh] = heightsAt(b.air, 0, wallOf(b).length);
    const VertexFan::Heights both = {std::max(aLow, bLow), std::min(aHigh, bHigh)};
    if (both.zTop - both.zBottom <= kHeightNoise) return;
    const auto joinOneWay = [&](const UprightSurface& from, const UprightSurface& to) {
      for (const auto& [zBottom, zTop] :
           fan_.waysRound(wallOf(from), vertex, wallOf(to).sector, both))
        join(from.id, to.id, onGrid(a, {1, zBottom}), onGrid(a, {1, zTop}));
    };
    joinOneWay(a, b);
    joinOneWay(b, a);
  }

  const Segment& wallOf(const UprightSurface& surface) const {
    return scene_[*scene_[surface.id].segment];
  }

  bool onOneGrid(SurfaceId a, SurfaceId b) const {
    return lit_[a.index()]->grid == lit_[b.index()]->grid;
  }

  /// Joins floors (ceilings) that are one plane on both sides of an opening. The other side's own
  /// segment says the same the other way round, where it opens.
  void joinFlats(const Segment& segment, bool floor) {
    const std::optional<SurfaceId> mine = flatOf(segment.sector, floor);
    if (!mine) return;
    const Sector& sector = scene_[segment.sector];
    const auto onMyGrid = [&](Vec2 p) {
      const double z = floor ? scene_.airBottom(sector, p) : scene_.airTop(sector, p);
      return lit_[mine->index()]->grid.toTexels({p.x, p.y, z});
    };
    for (const OpenStretch& open : openAtFoot(scene_, segment, floor)) {
      const std::optional<SurfaceId> other = flatOf(open.next, floor);
      if (!other || other == mine) continue;
      if (!continueInOnePlane(scene_, sector, scene_[open.next], floor, segment)) continue;
      join(*mine, *other, onMyGrid(lerp(segment.p0, segment.p1, open.begin)),
           onMyGrid(lerp(segment.p0, segment.p1, open.end)));
    }
  }

  std::optional<SurfaceId> flatOf(SectorId id, bool floor) const {
    const Sector& sector = scene_[id];
    const std::optional<SurfaceId> surface = floor ? sector.floorSurface : sector.ceilingSurface;
    return surface && lit_[surface->index()] ? surface : std::nullopt;
  }

  Scene scene_;
  const VertexFan& fan_;
  const std::vector<std::vector<UprightSurface>>& upright_;
  LitSurfaces& lit_;
};

}  // namespace

void joinContinuations(const Scene& scene, const VertexFan& fan,
                       const std::vector<std::vector<UprightSurface>>& upright,
                       LitSurfaces& surfaces) {
  Joiner(scene, fan, upright, surfaces).joinAll();
}

}  // namespace hearth
