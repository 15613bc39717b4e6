#pragma once

#include <optional>
#include <string>
#include <vector>

#include "level/ids.h"
#include "level/texture_mapping.h"
#include "math/box.h"
#include "math/vec.h"

namespace hearth {

struct Flat {
  double z = 0;                            ///< absolute, as authored
  std::optional<TextureMapping> texture;   ///< none where nothing shows: a flat portal
  Vec2 textureOrigin = {0, 0};             ///< (xr, yr): where u and v are 0
  bool isSky = false;                      ///< sky
  std::optional<FlatPortalId> flatPortal;  ///< a flat portal
};

/// A wedge of solid standing on the floor (hanging from the ceiling) of its sector. Its surface is
/// the plane z = zAt0 + gradient . ((x, y) - origin).
struct Slope {
  Vec2 origin;      ///< the first vertex of the border, as authored
  double zAt0 = 0;  ///< absolute height at `origin`
  Vec2 gradient;    ///< rise per metre along x and y
  std::optional<TextureMapping> sidewall;
  bool isRelative = false;  ///< the sidewalls' v is 0 at the slope's own edge, unless they say
  double zAt(Vec2 p) const { return zAt0 + dot(gradient, p - origin); }
};

struct Loop {
  std::string name;
  SegmentId first;  ///< its segments are contiguous
  std::uint32_t count = 0;
};

struct Sector {
  std::string name;
  double light = 0;  ///< 0..1, added to the baked light
  Flat floor;
  Flat ceiling;
  std::optional<Slope> floorSlope;
  std::optional<Slope> ceilingSlope;
  std::vector<Loop> loops;  ///< the border first
  SegmentId firstSegment;   ///< all segments of all its loops are contiguous
  std::uint32_t segmentCount = 0;

  // Set by `linkSurfaces`:
  SectorId id;
  Box box;                                ///< around its outline
  std::optional<SurfaceId> floorSurface;  ///< none for a flat portal
  std::optional<SurfaceId> ceilingSurface;
  std::uint32_t firstEntrance = 0;  ///< see Level::entrancesOf
  std::uint32_t entranceCount = 0;
  std::optional<std::uint32_t> wallGrid;  ///< index into Level::wallGrids, where it has many walls

  /// Heights of the sector's air above a point in plan, slopes included, where its flats are as
  /// authored. `Scene` has those of the flats as they are.
  double authoredBottom(Vec2 p) const { return floorSlope ? floorSlope->zAt(p) : floor.z; }
  double authoredTop(Vec2 p) const { return ceilingSlope ? ceilingSlope->zAt(p) : ceiling.z; }
};

/// Flats at one height that open to each other: flat portals.
enum class FlatPortalSide { Upper, Lower };

struct FlatPortal {
  std::string name;
  double z = 0;
  std::vector<SectorId> upper;  ///< sectors whose floor it is
  std::vector<SectorId> lower;  ///< sectors whose ceiling it is

  const std::vector<SectorId>& members(FlatPortalSide side) const {
    return side == FlatPortalSide::Upper ? upper : lower;
  }
};

}  // namespace hearth
