#pragma once

#include "level/ids.h"
#include "math/vec.h"

/// Lights that are areas of a level. Intensities are levels (255 is full), colours the factors of
/// red, green and blue, 0..1.
namespace hearth {

/// All surfaces of a level that wear a texture shine, from their front: not its skies, sprites and
/// middle textures.
struct Emitter {
  TextureId texture;
  double intensity = 0;  ///< at a surface that sees nothing else
  Vec3 color{1, 1, 1};
};

}  // namespace hearth
