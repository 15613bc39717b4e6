#pragma once

#include <vector>

#include "level/level.h"
#include "math/vec.h"

namespace hearth {

/// What surfaces that shine add to the light of their sector where they are drawn: fractions of
/// red, green and blue; 1 and more show a texture as it is.
class Glow {
 public:
  explicit Glow(const Level& level);

  /// Of a surface, or one face of a mesh, that wears a texture.
  Vec3 of(SurfaceKind kind, TextureId texture) const {
    return ofTextures_.empty() || !canShine(kind) ? Vec3{} : ofTextures_[texture.index()];
  }

 private:
  std::vector<Vec3> ofTextures_;  ///< by TextureId; empty where none shine
};

}  // namespace hearth
