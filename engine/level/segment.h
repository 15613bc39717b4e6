#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "level/ids.h"
#include "level/wall.h"
#include "math/vec.h"

namespace hearth {

/// Part of a wall that leads on to `next`.
struct Opening {
  SectorId next;
  SegmentId twin;  ///< the segment of `next` with the same two end points, the other way round
  /// What of the next sector's wedges can stand in the opening; none where it has no slope.
  std::optional<SurfaceId> floorSidewall;
  std::optional<SurfaceId> ceilingSidewall;
  std::optional<SurfaceId> maskedMiddle;  ///< what hangs in it, seen from this side
};

/// What a segment holds between two heights: something that shows, or a way on.
struct WallPiece {
  double zBottom;  ///< absolute
  double zTop;     ///< absolute, > zBottom
  std::variant<SurfaceId, Opening> content;
};

/// What light passes: as the openings, but endless above (below) between two skies.
struct LightOpening {
  double zBottom;  ///< absolute, or -infinity
  double zTop;     ///< absolute, or +infinity
  SectorId next;
  SegmentId twin;
  std::vector<SurfaceId> maskedMiddles;  ///< that hang in it, seen from either side
};

/// The sector's air at one end of a segment: between its floor and its ceiling, slopes included.
struct AirColumn {
  double zBottom;
  double zTop;

  friend constexpr bool operator==(AirColumn, AirColumn) = default;
};

/// A piece of a sector's outline. Seen from the front (from inside the sector) p0 is on the left.
///
/// Linking splits authored walls wherever a wall that they open to has a vertex, so that every
/// portal segment has exactly one twin with the same end points to the bit: neighbours cannot
/// disagree about where one ends.
struct Segment {
  Vec2 p0;
  Vec2 p1;
  SectorId sector;
  std::uint32_t loop = 0;  ///< index into Sector::loops
  std::uint32_t wall = 0;  ///< index of the authored wall in its loop's file order
  double sBefore = 0;      ///< metres of the authored wall before p0 ...
  double sAfter = 0;       ///< ... and after p1
  Wall kind;

  // Derived by `finishLevel`:
  double length = 0;              ///< metres
  AirColumn air0{};               ///< at p0
  AirColumn air1{};               ///< at p1
  bool airRises = false;          ///< the two differ: over a slope
  std::vector<WallPiece> pieces;  ///< bottom to top; cover the air without a gap
  std::vector<LightOpening> lightOpenings;
};

}  // namespace hearth
