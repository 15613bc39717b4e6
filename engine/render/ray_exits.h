#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "level/scene.h"
#include "render/by_id.h"
#include "render/camera.h"
#include "render/segment_columns.h"
#include "render/segment_front.h"
#include "render/window.h"

namespace hearth {

/// A stretch of a column's ray inside one sector, up to `exit`.
struct Stretch {
  SectorId sector;
  ColumnHit exit;
};

/// The memory of RayExits, kept from frame to frame.
struct RayExitScratch {
  ById<SectorId, SegmentFront> fronts;    ///< of sectors without a wall grid
  ById<CellId, SegmentFront> cellFronts;  ///< of wall grids
  std::vector<double> slants;             ///< of the rays of the columns, see Projection::slantOf
  std::vector<ColumnHit> closest;         ///< by window of the present viewport

  /// Of the present look through a flat portal: as they are found, with their windows, ...
  std::vector<std::pair<std::size_t, Stretch>> stretches;
  /// ... and by window: those of window i are [stretchesBegin[i], stretchesBegin[i + 1]).
  std::vector<Stretch> stretchesByWindow;
  std::vector<std::size_t> stretchesBegin;
  std::vector<ColumnHit> crossed;  ///< of one of its windows, in one wall grid
};

/// Where the rays through windows leave the sectors behind them, in one frame. Windows are by
/// rising column, which may repeat; at least one of them, and all of them in the columns of the
/// frame.
class RayExits {
 public:
  /// `columns` are of a screen that is so wide.
  RayExits(const Scene& scene, const Projection& projection, int width, ColumnRange columns,
           RayExitScratch& scratch);

  /// The depth where there is no exit.
  static constexpr double kNoDepth = std::numeric_limits<double>::infinity();

  /// For every window the nearest segment of a sector, seen from its front, beyond the entry; at
  /// kNoDepth where there is none. Valid until the next call.
  const std::vector<ColumnHit>& closest(SectorId sector, std::optional<SegmentId> entry,
                                        const std::vector<Window>& windows);

  /// For every window the stretches of its column inside the members, by rising depth. Only where
  /// the ray leaves a member matters: where it came in, another stretch has ended.
  void findStretches(const std::vector<SectorId>& members, const std::vector<Window>& windows);
  /// Those of a window, as they have been found last.
  std::span<const Stretch> stretchesOf(std::size_t window) { return stretchesIn(window); }

  int projectedSegments() const { return projectedSegments_; }

 private:
  template <typename Met>
  void meetSegments(SectorId sector, std::optional<SegmentId> except,
                    const std::vector<Window>& windows, Met&& met);
  std::span<const SegmentFront> frontsOf(SectorId sector);
  std::span<const SegmentFront> frontsIn(SectorId sector, const WallGrid& grid, CellId cell);
  template <typename Fronts>
  void addFront(const Segment& segment, Fronts& fronts);
  template <typename Met, typename End>
  void walkCells(SectorId sector, const WallGrid& grid, int column, double from, Met&& met,
                 End&& end);
  const std::vector<ColumnHit>& crossings(SectorId sector, const WallGrid& grid, int column);
  double slantOf(int column) const;
  bool isBeyond(std::optional<SegmentId> entry, double entryDepth, const ColumnHit& hit) const;
  bool isNearer(const ColumnHit& a, const ColumnHit& b) const;
  bool inOrder(SegmentId a, SegmentId b) const;
  std::span<Stretch> stretchesIn(std::size_t window);
  void groupByWindow(std::size_t windowCount);
  void sortByDepth(std::span<Stretch> stretches) const;

  Scene scene_;
  const Projection& projection_;
  int width_;
  ColumnRange columns_;
  RayExitScratch& scratch_;
  int projectedSegments_ = 0;
};

}  // namespace hearth
