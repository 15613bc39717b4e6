#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "level/scene.h"
#include "render/segment_columns.h"
#include "render/span.h"

namespace hearth {

/// Rows [top, bottom) of one column that are still open.
struct Window {
  /// As of Span.
  Window(int atColumn, int begin, int end, double atDepth)
      : column(atColumn), top(begin), bottom(end), depth(atDepth) {}

  int column;
  int top;
  int bottom;
  double depth;  ///< metres at which the column leaves the sector in front
};

/// A sector seen through the windows that a portal leaves open.
struct Viewport {
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

/// A stretch of a column's ray inside one sector, up to `exit`.
struct Stretch {
  SectorId sector;
  ColumnHit exit;
};

/// Lists of windows that nothing uses at the moment. Each has room for a window in every column, so
/// a viewport can get any of them.
class SpareWindows {
 public:
  std::vector<Window> take(int columns) {
    std::vector<Window> windows;
    if (!spare_.empty()) {
      windows = std::move(spare_.back());
      spare_.pop_back();
    }
    windows.reserve(static_cast<std::size_t>(columns));
    return windows;
  }
  void giveBack(std::vector<Window>&& windows) {
    windows.clear();
    spare_.push_back(std::move(windows));
  }

 private:
  std::vector<std::vector<Window>> spare_;
};

/// The memory of the search for visible spans. Kept from frame to frame, it soon grows no more.
struct VisibilityScratch {
  VisibleSpans found;               ///< of the last frame
  std::vector<Span> maskedMiddles;  ///< of the present frame, as they are found: near to far

  std::vector<Viewport> viewports;
  std::vector<FlatPortalView> flatPortals;
  SpareWindows spareWindows;
  std::vector<ColumnHit> closest;  ///< by window of the present viewport
  std::vector<double> slants;      ///< of the rays of the columns, see Projection::slantOf

  /// Of the present look through a flat portal: as they are found, with their windows, ...
  std::vector<std::pair<std::size_t, Stretch>> stretches;
  /// ... and by window: those of window i are [stretchesBegin[i], stretchesBegin[i + 1]).
  std::vector<Stretch> stretchesByWindow;
  std::vector<std::size_t> stretchesBegin;
};

}  // namespace hearth
