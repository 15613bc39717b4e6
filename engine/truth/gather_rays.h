#pragma once

#include <cstdint>
#include <optional>

#include "truth/trace.h"
#include "truth/truth_meshes.h"

namespace hearth {

/// A direction whose frequency goes with the cosine to a normal of length 1. `u` and `v` are evenly
/// spread in 0..1 (Malley's method; Pharr, Jakob, Humphreys, "Physically Based Rendering", 13.6.3).
Vec3 cosineDirection(Vec3 normal, double u, double v);

/// Rays from a point of a surface or of the air to where light may come from.
class GatherRays {
 public:
  /// From a surface into the air before it. Keeps references to the level and its meshes. It has no
  /// rays where a point of a mesh lies in no air of a sector that the mesh is in.
  GatherRays(const Level& level, const TruthMeshes& meshes, const SurfacePoint& place);
  /// From a point inside the air of a sector, or on its border.
  GatherRays(const Level& level, const TruthMeshes& meshes, Vec3 point, SectorId sector);

  /// The first surface that it meets in a direction of length 1: a sky, a surface from its front, a
  /// masked middle texture or a mesh that casts a shadow from either side. None if it has no rays.
  std::optional<TruthHit> firstMet(Vec3 direction) const;
  /// Whether it meets a sky in that direction.
  bool seesSky(Vec3 direction) const;

 private:
  const Level& level_;
  const TruthMeshes& meshes_;
  Vec3 origin_;
  std::optional<SectorId> sector_;
  std::optional<std::uint32_t> face_;  ///< on which it starts
};

}  // namespace hearth
