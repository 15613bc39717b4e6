#pragma once

#include <string_view>
#include <vector>

#include "level/level.h"

namespace hearth {

/// The names of all textures that shine if an emitter names them: those of walls, flats and meshes.
/// Each once, sorted. `linkSurfaces` has run.
std::vector<std::string_view> texturesThatCanShine(const Level& level);

}  // namespace hearth
