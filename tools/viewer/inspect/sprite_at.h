#pragma once

#include <cstddef>
#include <optional>

#include "level/scene.h"
#include "render/texture.h"

namespace hearth {

/// A look into a level.
struct SpriteLook {
  SectorId sector;  ///< of the eye, strictly inside its air
  Vec3 eye;
  Vec3 direction;     ///< of any length
  Vec2 pictureRight;  ///< of length 1: along it stand the sprites that face the camera
};

/// A sprite that a look meets.
struct SpriteHit {
  std::size_t sprite;  ///< its index in the level
  TextureId image;     ///< that it shows at time 0
  double t;            ///< point = eye + t * direction

  friend bool operator==(const SpriteHit&, const SpriteHit&) = default;
};

/// The nearest sprite that a look meets no farther than `tEnd`, with a texel that is no hole. The
/// line to that point, and on from there to the sprite's position, must lie in the air: what an
/// image shows round a corner is not found.
std::optional<SpriteHit> spriteAt(const Scene& scene, const DrawnTextures& textures,
                                  const SpriteLook& look, double tEnd);

}  // namespace hearth
