#pragma once

#include "math/vec.h"

namespace hearth {

/// The one mapping between the world and the texels of a lightmap. Texel (i, j) covers
/// [i, i+1) x [j, j+1) of the texel coordinates; they are anchored to the plane of the surface, not
/// to the surface, so that cutting it in two moves no texel.
struct TexelGrid {
  Vec3 origin;  ///< texel coordinates (0, 0)
  Vec3 axisS;   ///< unit vectors in the plane
  Vec3 axisT;
  double texel = 0.125;  ///< metres

  friend bool operator==(const TexelGrid&, const TexelGrid&) = default;

  Vec2 toTexels(Vec3 p) const {
    return {dot(p - origin, axisS) / texel, dot(p - origin, axisT) / texel};
  }
  Vec3 toWorld(Vec2 texels) const {
    return origin + (texels.x * texel) * axisS + (texels.y * texel) * axisT;
  }
};

}  // namespace hearth
