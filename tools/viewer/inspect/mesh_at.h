#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "level/level.h"
#include "viewer/inspect/sprite_at.h"

namespace hearth {

/// A mesh that a look meets.
struct MeshHit {
  std::size_t mesh;    ///< its index in the level
  std::uint32_t face;  ///< index into Level::meshFaces
  double t;            ///< point = eye + t * direction
  Vec3 point;

  friend bool operator==(const MeshHit&, const MeshHit&) = default;
};

/// The nearest face that a look meets in the air up to the first surface of the level. `eye` is
/// strictly inside the air of `sector`; `direction` goes 1 m deep before the camera, so that
/// parameters of the look are depths.
std::optional<MeshHit> meshAt(const Level& level, SectorId sector, Vec3 eye, Vec3 direction);

/// Whether a mesh hides a sprite that the same look meets: of two at one depth the later thing.
bool hides(const Level& level, const MeshHit& mesh, const SpriteHit& sprite);

}  // namespace hearth
