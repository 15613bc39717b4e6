#pragma once

#include <vector>

#include "level/level.h"

namespace hearth {

/// A convex polygon in space: its corners in their order around it. Of what it is cut to, at times
/// a line or a point. Empty if nothing is left.
using Polygon = std::vector<Vec3>;

/// The sectors that a thing in the air of a sector is in, by SectorId: that one, each to which an
/// opening or a flat portal leads from there that one of the thing's polygons crosses or touches,
/// and so on from these.
std::vector<bool> sectorsCrossedBy(const Level& level, SectorId sector,
                                   const std::vector<Polygon>& thing);

}  // namespace hearth
