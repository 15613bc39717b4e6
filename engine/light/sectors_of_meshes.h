#pragma once

#include <vector>

#include "level/level.h"

namespace hearth {

/// The sectors that each mesh is in.
std::vector<std::vector<SectorId>> sectorsOfMeshes(const Level& level);

}  // namespace hearth
