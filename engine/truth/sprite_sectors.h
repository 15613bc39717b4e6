#pragma once

#include <array>
#include <vector>

#include "level/level.h"

namespace hearth {

/// The corners of a rectangle in space, in their order around it.
using Corners = std::array<Vec3, 4>;

/// The sectors that an upright or level rectangle in the air of a sector is in, by SectorId: that
/// one, each to which an opening or a flat portal leads from there that the rectangle crosses or
/// touches, and so on from these.
std::vector<bool> sectorsCrossedBy(const Level& level, SectorId sector, const Corners& corners);

}  // namespace hearth
