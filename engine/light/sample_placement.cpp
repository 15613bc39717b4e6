#include "light/sample_placement.h"

#include <algorithm>
#include <array>

#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr std::array<Vec2, 16> kWays = {{{1, 0},
                                         {0, 1},
                                         {-1, 0},
                                         {0, -1},
                                         {0.7, 0.7},
                                         {-0.7, 0.7},
                                         {0.7, -0.7},
                                         {-0.7, -0.7},
                                         {0.9, 0.4},
                                         {0.4, 0.9},
                                         {-0.4, 0.9},
                                         {-0.9, 0.4},
                                         {-0.9, -0.4},
                                         {-0.4, -0.9},
                                         {0.4, -0.9},
                                         {0.9, -0.4}}};

}  // namespace

SamplePlacement::SamplePlacement(const LitSurfaces& surfaces, SurfaceId id)
    : surfaces_(surfaces), id_(id), hair_(kHair / surfaces[id.index()]->grid.texel) {}

SamplePoint SamplePlacement::place(Vec2 p) const {
  const LitSurface& own = *surfaces_[id_.index()];
  if (own.contains(p)) return at(id_, p, p);
  const Patch patch = patchWithin(length(own.nearest(p) - p) + hair_, p);
  if (const std::optional<SurfaceId> other = surfaceAt(patch, p)) return at(*other, p, p);
  SurfaceId surface = id_;
  Vec2 best = own.nearest(p);
  for (const SurfaceId id : patch) {
    const Vec2 q = surfaces_[id.index()]->nearest(p);
    if (length(q - p) < length(best - p)) surface = id, best = q;
  }
  return at(surface, best, p);
}

SamplePoint SamplePlacement::at(SurfaceId id, Vec2 p, Vec2 from) const {
  const LitSurface& surface = *surfaces_[id.index()];
  const bool onEdge = length(surface.nearest(p) - p) < hair_;
  return {surface.toWorld(p), id, surface.toWorld(onEdge ? movedInside(surface, p, from) : p)};
}

SamplePlacement::Patch SamplePlacement::patchWithin(double reach, Vec2 p) const {
  Patch patch = {id_};
  for (std::size_t i = 0; i < patch.size(); ++i)
    for (const Continuation& next : surfaces_[patch[i].index()]->continuations)
      if (std::ranges::find(patch, next.surface) == patch.end() &&
          length(nearestOnSegment(next.edge0, next.edge1, p) - p) <= reach)
        patch.push_back(next.surface);
  return patch;
}

std::optional<SurfaceId> SamplePlacement::surfaceAt(const Patch& patch, Vec2 p) const {
  for (const SurfaceId id : patch)
    if (surfaces_[id.index()]->contains(p)) return id;
  return std::nullopt;
}

/// From a point on the surface's edge a hair inwards: straight on from where the sample was, or in
/// a corner, where that may run along the other edge, the way that leads farthest inside.
Vec2 SamplePlacement::movedInside(const LitSurface& surface, Vec2 edgePoint, Vec2 from) const {
  std::vector<Vec2> ways;
  if (edgePoint != from) ways.push_back((1 / length(edgePoint - from)) * (edgePoint - from));
  ways.insert(ways.end(), kWays.begin(), kWays.end());
  Vec2 best = edgePoint;
  double clearance = 0;
  for (const Vec2 way : ways) {
    const Vec2 candidate = edgePoint + hair_ * way;
    if (!surface.contains(candidate)) continue;
    const double found = length(surface.nearest(candidate) - candidate);
    if (found > 0.9 * hair_) return candidate;
    if (found > clearance) best = candidate, clearance = found;
  }
  return best;
}

}  // namespace hearth
