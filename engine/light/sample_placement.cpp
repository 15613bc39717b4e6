#include "light/sample_placement.h"

#include <algorithm>
#include <array>

#include "math/predicates.h"

namespace hearth {

namespace {

/// Metres. Samples keep about this far off the edges of their surface, so that on which side of a
/// wall's foot a ray arrives is not left to rounding. A shadow moves by no more.
constexpr double kHair = 1e-6;

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
  const double distance = length(own.nearest(p) - p);
  const bool inside = own.contains(p);
  if (inside && distance > hair_) return at(id_, p);

  const Patch patch = patchWithin(inside ? hair_ : distance + hair_, p);
  const Vec2 onPatch = surfaceAt(patch, p) ? p : nearestOf(patch, p);
  const Vec2 settled = isOffEdges(patch, onPatch) ? onPatch : movedOffEdges(patch, onPatch, p);
  return at(surfaceAt(patch, settled).value_or(id_), settled);
}

SamplePoint SamplePlacement::at(SurfaceId surface, Vec2 texelPoint) const {
  return {surfaces_[surface.index()]->toWorld(texelPoint), surface};
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

Vec2 SamplePlacement::nearestOf(const Patch& patch, Vec2 p) const {
  Vec2 best = surfaces_[id_.index()]->nearest(p);
  for (const SurfaceId id : patch) {
    const Vec2 q = surfaces_[id.index()]->nearest(p);
    if (length(q - p) < length(best - p)) best = q;
  }
  return best;
}

/// Whether the patch goes on all around the point: a cut between two of its surfaces is no edge.
bool SamplePlacement::isOffEdges(const Patch& patch, Vec2 p) const {
  return std::ranges::all_of(
      kWays, [&](Vec2 way) { return surfaceAt(patch, p + (hair_ / 2) * way).has_value(); });
}

/// A hair away from the edges that `p` lies on: straight on from where the sample was, or the first
/// way that is clear. In a corner too acute for that, the way that leads farthest off its edges.
Vec2 SamplePlacement::movedOffEdges(const Patch& patch, Vec2 p, Vec2 from) const {
  std::vector<Vec2> ways;
  if (p != from) ways.push_back((1 / length(p - from)) * (p - from));
  ways.insert(ways.end(), kWays.begin(), kWays.end());
  Vec2 best = p;
  double clearance = 0;
  for (const Vec2 way : ways) {
    const Vec2 candidate = p + hair_ * way;
    const std::optional<SurfaceId> surface = surfaceAt(patch, candidate);
    if (!surface) continue;
    if (isOffEdges(patch, candidate)) return candidate;
    const double found = length(surfaces_[surface->index()]->nearest(candidate) - candidate);
    if (found > clearance) best = candidate, clearance = found;
  }
  return best;
}

}  // namespace hearth
