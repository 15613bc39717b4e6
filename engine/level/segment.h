#pragma once

#include <optional>

#include "level/ids.h"
#include "level/wall.h"
#include "math/vec.h"

namespace hearth {

/// The surfaces that a wall, or one sub-wall of a stack, can show at any heights of the flats
/// around it.
struct WallSurfaces {
  std::optional<SurfaceId> solid;  ///< of a solid wall; all others are of portals
  std::optional<SurfaceId> lower;  ///< the step, or the sky before it
  std::optional<SurfaceId> upper;
  std::optional<SurfaceId> maskedMiddle;
  std::optional<SurfaceId> floorSidewall;  ///< of the next sector's floor slope
  std::optional<SurfaceId> ceilingSidewall;
  std::optional<SegmentId> twin;        ///< the segment behind a portal, the other way round
  std::uint32_t firstMaskedMiddle = 0;  ///< of its light opening, in Geometry::maskedMiddles
};

/// A piece of a sector's outline. Seen from the front (from inside the sector) p0 is on the left.
///
/// Linking splits an authored wall at every vertex of the walls that it opens to. So every portal
/// segment has exactly one twin, with the same end points to the bit, and neighbours cannot
/// disagree about where it ends.
struct Segment {
  Vec2 p0;
  Vec2 p1;
  SectorId sector;
  std::uint32_t loop = 0;       ///< index into Sector::loops
  std::uint32_t wallIndex = 0;  ///< of the authored wall in its loop, as in the file
  double sBefore = 0;           ///< metres of the authored wall before p0 ...
  double sAfter = 0;            ///< ... and after p1
  Wall wall;

  // Set by `linkSurfaces`:
  SegmentId id;
  double length = 0;            ///< metres
  std::uint32_t firstWall = 0;  ///< index into Level::wallSurfaces
  std::uint32_t wallCount = 0;  ///< one, or one for each sub-wall of a stack
};

}  // namespace hearth
