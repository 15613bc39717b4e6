#pragma once

#include "random_levels/model.h"

namespace hearth::random_levels {

/// A random texture in a random spelling, for a wall, step or sidewall.
TextureUse wallTexture(Random& random);
/// Without `along` and `zref`, which flats do not know.
TextureUse flatTexture(Random& random);

}  // namespace hearth::random_levels
