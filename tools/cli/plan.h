#pragma once

#include <string>

#include "level/scene.h"

namespace hearth {

/// The level from above as SVG, x to the right and y down as in its file: sectors in the colour of
/// their floor's height, higher ones over lower ones, with names and heights where there is room;
/// walls, steps, portals, one-way portals and flat portals; meshes, sprites, lights, shots with
/// their names and the player; a key. The pointer shows the name of each part.
std::string planOf(const Scene& scene);

}  // namespace hearth
