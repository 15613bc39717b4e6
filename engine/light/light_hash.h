#pragma once

#include <cstdint>

#include "level/bake_settings.h"
#include "level/scene.h"

namespace hearth {

/// A hash of all that the light of a level depends on, except the program: its geometry, the holes
/// of its textures, which surfaces shine, its lights, and the settings of the bake; the same on
/// every machine.
std::uint64_t lightHash(const Scene& scene, const BakeSettings& settings);

}  // namespace hearth
