#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/level.h"

namespace hearth {

/// A portal without a wall of the next sector behind it.
struct MissingTwin {
  SegmentId segment;
  std::uint32_t subWall;  ///< 0 for a wall that is no stack
};

/// Adds all that the comments of Level, Sector and Segment say `linkSurfaces` sets. Returns the
/// portals that lead nowhere; with any, do not use the level.
///
/// Expects: segments split so that both sides of every portal have the same end points, slopes that
/// are planes, flats with a texture (skies too) or a flat portal.
std::vector<MissingTwin> linkSurfaces(Level& level);

/// Sets `Level::wallGrids`, of the sectors with no fewer walls. `linkSurfaces` has done so with the
/// number from which on it saves time; nothing that is seen, lit or met depends on it.
void addWallGrids(Level& level, std::size_t fewestWalls);

}  // namespace hearth
