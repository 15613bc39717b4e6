#pragma once

#include "level/ids.h"
#include "math/vec.h"

/// Lights without a place in the air of a level. Intensities are levels (255 is full), colours the
/// factors of red, green and blue, 0..1.
namespace hearth {

/// Light from infinitely far. A point sees it where the straight line towards it ends in the sky.
struct Sun {
  double angle = 0;   ///< degrees; where one looks to see it: 0 along +x, 90 along +y ...
  double pitch = 90;  ///< ... and so far up
  double intensity = 255;
  Vec3 color{1, 1, 1};
  double size = 0;  ///< degrees, the diameter of its disc; 0 is a point

  /// Towards it, of length 1.
  Vec3 direction() const;
};

/// All skies of a level, as one dome of the same radiance.
struct SkyLight {
  double intensity = 0;  ///< at level ground in the open
  Vec3 color{1, 1, 1};
};

/// All surfaces of a level that wear a texture shine, from their front: not its skies, sprites and
/// middle textures.
struct Emitter {
  TextureId texture;
  double intensity = 0;  ///< at a surface that sees nothing else
  Vec3 color{1, 1, 1};
};

}  // namespace hearth
