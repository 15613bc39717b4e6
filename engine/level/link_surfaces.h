#pragma once

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

}  // namespace hearth
