#pragma once

#include <optional>
#include <vector>

#include "level/scene.h"
#include "render/lanes.h"
#include "render/ray_exits.h"
#include "render/span_groups.h"
#include "render/window.h"

namespace hearth {

/// A sector seen through the windows that a portal leaves open.
struct Viewport {
  const Opening* opening;  ///< null for the camera's sector
  SectorId sector;
  std::optional<SegmentId> entry;  ///< the sector's own side of that portal
  std::vector<Window> windows;     ///< by rising column
};

/// The sectors of one side of a flat portal, seen through the windows that a flat portal leaves.
struct FlatPortalView {
  FlatPortalId flatPortal;
  bool down;
  std::vector<Window> windows;
};

/// What a wall shows in some columns: a surface or an opening, in these rows.
struct WallPart {
  const Opening* opening;  ///< null if it is a surface
  SurfaceId surface;
  LaneRowRanges rows;
};

/// The memory of the search for visible spans. Kept from frame to frame, it soon grows no more.
struct VisibilityScratch {
  VisibleSpans found;  ///< of the last frame

  std::vector<Viewport> viewports;
  std::vector<FlatPortalView> flatPortals;
  SpareWindows spareWindows;
  RayExitScratch rayExits;
  std::vector<WallPart> wallParts;  ///< of the present columns
  std::vector<ColumnHit> closest;   ///< by window of the present viewport
  std::vector<double> slants;       ///< of the rays of the columns, see Projection::slantOf

  /// Of the present look through a flat portal: as they are found, with their windows, ...
  std::vector<std::pair<std::size_t, Stretch>> stretches;
  /// ... and by window: those of window i are [stretchesBegin[i], stretchesBegin[i + 1]).
  std::vector<Stretch> stretchesByWindow;
  std::vector<std::size_t> stretchesBegin;
};

}  // namespace hearth
