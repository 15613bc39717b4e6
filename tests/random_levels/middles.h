#pragma once

#include "random_levels/model.h"

namespace hearth::random_levels {

/// Hangs masked middle textures in so many of the portals.
void hangMiddles(Random& random, Model& model, double fraction);

}  // namespace hearth::random_levels
