#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "level/ids.h"
#include "level/level.h"

namespace hearth {

/// Part of a wall that leads on to `next`.
struct Opening {
  SectorId next;
  SegmentId twin;  ///< the segment of `next` with the same two end points, the other way round
  /// The next sector's wedges that can stand in the opening; none where it has no slope.
  std::optional<SurfaceId> floorSidewall;
  std::optional<SurfaceId> ceilingSidewall;
  std::optional<SurfaceId> maskedMiddle;  ///< its masked texture, seen from this side

  friend bool operator==(const Opening&, const Opening&) = default;
};

/// A part of a segment between two heights: a surface or an opening.
struct WallPiece {
  double zBottom;  ///< absolute
  double zTop;     ///< absolute, > zBottom
  std::variant<SurfaceId, Opening> content;

  friend bool operator==(const WallPiece&, const WallPiece&) = default;
};

/// A part of a segment that light passes: like an opening, but endless above (below) between two
/// skies.
struct LightOpening {
  double zBottom;  ///< absolute, or -infinity
  double zTop;     ///< absolute, or +infinity
  SectorId next;
  SegmentId twin;
  std::uint32_t firstMaskedMiddle = 0;  ///< see Scene::maskedMiddlesIn
  std::uint32_t maskedMiddleCount = 0;
};

/// A sector's air above one point in plan: between its floor and its ceiling, slopes included.
struct AirColumn {
  double zBottom;
  double zTop;

  friend constexpr bool operator==(AirColumn, AirColumn) = default;
};

/// The absolute heights of a sector's flats.
struct SectorGeometry {
  double zFloor;
  double zCeiling;

  friend bool operator==(const SectorGeometry&, const SectorGeometry&) = default;
};

struct SegmentGeometry {
  AirColumn air0{};       ///< at p0
  AirColumn air1{};       ///< at p1
  bool airRises = false;  ///< the two differ: over a slope
  std::uint32_t pieceCount = 0;
  std::uint32_t lightOpeningCount = 0;

  friend bool operator==(const SegmentGeometry&, const SegmentGeometry&) = default;
};

struct SurfaceGeometry {
  bool shows = false;  ///< if not, the rest is unused
  /// Upright: the absolute heights between which it may show. Sidewalls: those of the opening
  /// that they stand in; what their slope covers of it, `openingSpan` in level/openings.h tells.
  /// Masked middle textures: those of the image in its opening.
  double zBottom = 0;
  double zTop = 0;
  /// Of an upright surface: the absolute height at which v is 0. None for sky, and for a sidewall
  /// that follows its slope's edge.
  std::optional<double> zRef;

  friend bool operator==(const SurfaceGeometry&, const SurfaceGeometry&) = default;
};

/// All that follows from the heights of a level's flats, in flat arrays: which parts of each wall
/// show and where it opens. `Scene` reads it. Its arrays have room for every part of a wall that
/// can show at other heights, so `moveFlats` takes no memory.
struct Geometry {
  static constexpr std::size_t kPiecesPerWall = 3;  ///< lower step, opening, upper step

  std::vector<SectorGeometry> sectors;    ///< by SectorId
  std::vector<SegmentGeometry> segments;  ///< by SegmentId
  std::vector<SurfaceGeometry> surfaces;  ///< by SurfaceId
  /// Those of a segment begin at `kPiecesPerWall` times its `firstWall`.
  std::vector<WallPiece> pieces;
  std::vector<LightOpening> lightOpenings;  ///< those of a segment begin at its `firstWall`
  std::vector<SurfaceId> maskedMiddles;     ///< of all light openings
};

/// A place where a surface without a texture shows.
struct MissingTexture {
  SegmentId segment;      ///< on which it shows; for a sidewall, that of the viewing sector
  std::uint32_t subWall;  ///< 0 for a wall that is no stack
  SurfaceKind kind;
};

/// The geometry at the authored heights. Adds surfaces that show without a texture to `missing`; if
/// there are any, do not use the geometry.
///
/// Expects a level that `linkSurfaces` has completed.
Geometry deriveGeometry(const Level& level, std::vector<MissingTexture>& missing);

/// Adds a surface for each sprite and each mesh to a level that has none yet, and shows them.
void addThingSurfaces(Level& level, Geometry& geometry);

/// Where the flats of one sector move to.
struct MovedFlats {
  SectorId sector;
  SectorGeometry heights;
};

/// Moves flats of some sectors at once, and derives these and the walls that lead into them anew.
/// The time depends on these alone. Stacks move with their floor; things stay where they are.
///
/// Expects: zFloor <= zCeiling, sub-walls of stacks between them. Flats that are sky, flat portals
/// or carry a slope stay where they are. Textures are expected where steps show, or such steps are
/// added to `missing` and the geometry is not to be used.
void moveFlats(const Level& level, std::span<const MovedFlats> moved, Geometry& geometry,
               std::vector<MissingTexture>* missing = nullptr);
/// Of one sector.
void moveFlats(const Level& level, SectorId sector, SectorGeometry heights, Geometry& geometry);

}  // namespace hearth
