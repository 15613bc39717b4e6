#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "level/scene.h"
#include "render/lanes.h"
#include "render/mesh_spans.h"
#include "render/ray_exits.h"
#include "render/span_groups.h"
#include "render/sprite_spans.h"
#include "render/window.h"

namespace hearth {

/// A sector seen through the windows that a portal leaves open.
struct Viewport {
  const Opening* opening;  ///< null for the camera's sector
  SectorId sector;
  std::optional<SegmentId> entry;  ///< the sector's own side of that portal
  std::optional<SectorId> from;    ///< the sector on its other side
  std::vector<Window> windows;     ///< by rising column

  /// In the level: rising from opening to opening.
  const Opening* place() const { return opening; }
};

/// The sectors of one side of a flat portal, seen through the windows that a flat portal leaves.
struct FlatPortalView {
  FlatPortalId flatPortal;
  bool down;
  std::vector<Window> windows;

  std::pair<FlatPortalId, bool> place() const { return {flatPortal, down}; }
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
  SpriteSpansScratch sprites;
  MeshSpansScratch meshes;
  std::vector<WallPart> wallParts;  ///< of the present columns
};

}  // namespace hearth
