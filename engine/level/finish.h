#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "level/level.h"

namespace hearth {

/// A place where something can be seen that has no texture.
struct MissingTexture {
  SegmentId segment;      ///< on which it shows; for a sidewall, that of the viewing sector
  std::uint32_t subWall;  ///< 0 for a wall that is no stack
  SurfaceKind kind;
};

/// A portal without a wall of the next sector behind it.
struct MissingTwin {
  SegmentId segment;
  std::uint32_t subWall;
};

using LevelFault = std::variant<MissingTexture, MissingTwin>;

/// Derives all that the comments of Level, Sector and Segment call derived, from the rest. Returns
/// the author's mistakes that only this step can detect; with any, do not use the level.
///
/// Expects: segments split so that both sides of every portal have the same end points, slopes that
/// are planes, flats with a texture (skies too) or a flat portal.
std::vector<LevelFault> finishLevel(Level& level);

}  // namespace hearth
