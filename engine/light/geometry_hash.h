#pragma once

#include <cstdint>

#include "level/level.h"

namespace hearth {

/// A number of all that decides which surfaces the level has, in which order, and where their
/// texels of so many metres lie; the same on every machine. Names, textures, light and the player
/// are no part of it. saved_bake.md says what it is computed from.
std::uint64_t geometryHash(const Level& level, double texel);

}  // namespace hearth
