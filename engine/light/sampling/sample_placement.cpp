#include "light/sampling/sample_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory_resource>

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

double distanceTo(std::span<const Polygons::Edge> edges, Vec2 p) {
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : edges)
    distance = std::min(distance, length(nearestOnSegment(a, b, p) - p));
  return distance;
}

/// Between two edges that meet, the point that is `margin` from both. Clipping can leave an edge
/// between them that is all rounding.
std::optional<Vec2> insideCorner(const Polygons::Edge& before, const Polygons::Edge& after,
                                 double margin) {
  if (length(before.b - after.a) > margin) return std::nullopt;
  if (length(before.b - before.a) <= margin || length(after.b - after.a) <= margin)
    return std::nullopt;
  const Vec2 back = (1 / length(before.a - before.b)) * (before.a - before.b);
  const Vec2 on = (1 / length(after.b - after.a)) * (after.b - after.a);
  const double sine = std::abs(cross(back, on)) / length(back + on);  // of half the angle
  if (!(sine > 0)) return std::nullopt;
  return after.a + margin / (sine * length(back + on)) * (back + on);
}

/// Of what is small mostly: more is allocated.
struct StackMemory {
  std::array<std::byte, 512> bytes;
  std::pmr::monotonic_buffer_resource resource{bytes.data(), bytes.size()};
};

}  // namespace

SamplePlacement::SamplePlacement(const LitSurfaces& surfaces, SurfaceId id, SurfaceSet* sought)
    : surfaces_(surfaces),
      id_(id),
      hair_(kEdgeInset / surfaces[id.index()]->grid.texel),
      besideEdge_(2.5 * hair_),
      sought_(sought) {}

SamplePlacement::Rows::Rows(const SamplePlacement& placement)
    : placement_(placement), surface_(*placement.surfaces_[placement.id_.index()]) {}

void SamplePlacement::Rows::begin(double row) {
  // Texels. Samples of texels that are used are no farther from their surface.
  constexpr double kRowReach = 3;
  row_ = row;
  surface_.outline.findAroundRow(row, kRowReach, outline_);
  outline_.findBeside(row, placement_.besideEdge_, besideEdges_);
  next_ = 0;
}

SamplePoint SamplePlacement::Rows::place(double column) {
  const Vec2 p{column, row_};
  while (next_ < besideEdges_.size() && besideEdges_[next_].part.to < column) ++next_;
  if (next_ < besideEdges_.size() && besideEdges_[next_].part.from <= column)
    return placement_.place(p, outline_);
  if (next_ == 0 || !besideEdges_[next_ - 1].leadsInside)
    return placement_.placeOutside(p, outline_);
  const Vec3 point = surface_.toWorld(p);
  return {point, placement_.id_, point, false};
}

SamplePoint SamplePlacement::place(Vec2 p) const {
  return place(p, surfaces_[id_.index()]->outline);
}

SamplePoint SamplePlacement::place(Vec2 p, const Polygons& own) const {
  return own.contains(p) ? at(id_, own, p, p) : placeOutside(p, own);
}

SamplePoint SamplePlacement::placeOutside(Vec2 p, const Polygons& own) const {
  const Vec2 nearest = own.nearest(p);
  const double distance = length(nearest - p);
  if (distance < hair_) return at(id_, own, p, p);
  StackMemory memory;
  const Ids others = joinedWithin(distance + hair_, p, memory.resource);
  const auto outlineOf = [this](SurfaceId id) -> const Polygons& {
    return surfaces_[id.index()]->outline;
  };
  for (const SurfaceId id : others)
    if (const Vec2 there = onGridOf(id, p); holds(outlineOf(id), there))
      return at(id, outlineOf(id), there, there);
  SurfaceId surface = id_;
  Vec2 from = p;
  Vec2 best = nearest;
  for (const SurfaceId id : others) {
    const Vec2 there = onGridOf(id, p);
    const Vec2 q = outlineOf(id).nearest(there);
    if (length(q - there) < length(best - from) - hair_) surface = id, from = there, best = q;
  }
  return at(surface, surface == id_ ? own : outlineOf(surface), best, from);
}

/// A flat and a level wedge that continue one another have texels of their own each.
Vec2 SamplePlacement::onGridOf(SurfaceId id, Vec2 p) const {
  const TexelGrid& own = surfaces_[id_.index()]->grid;
  const TexelGrid& other = surfaces_[id.index()]->grid;
  return other == own ? p : other.toTexels(own.toWorld(p));
}

SamplePoint SamplePlacement::at(SurfaceId id, const Polygons& outline, Vec2 p, Vec2 from) const {
  const LitSurface& surface = *surfaces_[id.index()];
  StackMemory memory;
  const Polygons::EdgesNear edges = outline.edgesWithin(p, besideEdge_, memory.resource);
  const bool isOnEdge = p != from || distanceTo(edges, p) < hair_;
  return {surface.toWorld(p), id,
          surface.toWorld(isOnEdge ? movedInside(outline, edges, p, from) : p), p != from};
}

SamplePlacement::Ids SamplePlacement::joinedWithin(double reach, Vec2 p,
                                                   std::pmr::memory_resource& memory) const {
  Ids joined(&memory);
  const auto addBeside = [&](SurfaceId id) {
    const Vec2 there = onGridOf(id, p);
    for (const Continuation& next : surfaces_[id.index()]->continuations)
      if (next.surface != id_ && std::ranges::find(joined, next.surface) == joined.end() &&
          Polygons::Edge{next.edge0, next.edge1}.isWithin(reach, there))
        joined.push_back(next.surface);
  };
  addBeside(id_);
  for (std::size_t i = 0; i < joined.size(); ++i) addBeside(joined[i]);
  if (sought_) {
    sought_->add(id_);
    for (const SurfaceId id : joined) sought_->add(id);
  }
  return joined;
}

/// On the very edge it is not left to rounding.
bool SamplePlacement::holds(const Polygons& outline, Vec2 p) const {
  return outline.contains(p) || length(outline.nearest(p) - p) < hair_;
}

/// From a point on the surface's edge a hair inwards: straight on from where the sample was, or in
/// a corner, where that may run along the other edge, the way that leads farthest inside; in a
/// sharp one to where its edges are a hair away.
Vec2 SamplePlacement::movedInside(const Polygons& outline, std::span<const Polygons::Edge> edges,
                                  Vec2 edgePoint, Vec2 from) const {
  Vec2 best = edgePoint;
  double clearance = 0;
  const auto isGood = [&](Vec2 direction) {
    const Vec2 candidate = edgePoint + hair_ * direction;
    const double found = distanceTo(edges, candidate);
    if (found <= clearance || !outline.contains(candidate)) return false;
    best = candidate;
    clearance = found;
    return clearance > 0.9 * hair_;
  };
  if (edgePoint != from) {
    const Vec2 straightOn = (1 / length(edgePoint - from)) * (edgePoint - from);
    // Behind an edge that is alone, seen from outside, lies the inside.
    if (edges.size() == 1) return edgePoint + hair_ * straightOn;
    if (isGood(straightOn)) return best;
  }
  if (std::ranges::any_of(kWays, isGood) || clearance > 0.5 * hair_) return best;
  // A sharp corner, into which none of the ways leads, or not far from its edges.
  for (const Polygons::Edge& before : edges)
    for (const Polygons::Edge& after : edges) {
      const std::optional<Vec2> inside = insideCorner(before, after, hair_);
      if (inside && outline.contains(*inside)) return *inside;
    }
  return best;
}

}  // namespace hearth
