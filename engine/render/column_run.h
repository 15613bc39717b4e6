#pragma once

#include <cstddef>
#include <optional>

#include "level/scene.h"
#include "render/lanes.h"
#include "render/segment_columns.h"
#include "render/strip.h"
#include "render/window.h"

namespace hearth {

/// How the rays of a run come into its sector: through a wall, through a flat portal, or not at
/// all, if they begin there.
struct RunEntry {
  LaneDoubles depths{};          ///< metres at which they pass a wall; else 0
  std::optional<SectorId> from;  ///< the sector before that wall
  std::optional<double> plane;   ///< the height of the flat portal
};

/// Columns of one strip, seen in one viewport, that leave the sector at the same segment. What they
/// show is found for all of them together. The other lanes have no open rows, and the numbers of
/// the first column.
struct ColumnRun {
  ColumnRun(const Sector& ofSector, const Segment& atSegment, const Window& window,
            const ColumnHit& hit)
      : sector(ofSector),
        segment(atSegment),
        hasLevelAir(hit.hasLevelAir),
        strip(window.column / Strip::kColumns) {
    depths.fill(hit.depth);
    fractions.fill(hit.fraction);
    laneBegin = laneOf(window);
    add(window, hit);
  }

  /// Whether a window to the right of the last one belongs to it, too.
  bool continuesIn(const Window& window, const ColumnHit& hit) const {
    return hit.segment == segment.id && window.column / Strip::kColumns == strip &&
           laneOf(window) >= laneEnd;
  }

  void add(const Window& window, const ColumnHit& hit) {
    const std::size_t lane = laneOf(window);
    laneEnd = lane + 1;
    open.begin[lane] = window.top;
    open.end[lane] = window.bottom;
    depths[lane] = hit.depth;
    fractions[lane] = hit.fraction;
  }

  const Sector& sector;
  const Segment& segment;
  bool hasLevelAir;  ///< of the segment, see SegmentFront
  int strip;
  std::size_t laneBegin;
  std::size_t laneEnd;
  LaneRowRanges open;     ///< the windows
  LaneDoubles depths;     ///< metres
  LaneDoubles fractions;  ///< of the way from the segment's p0 to p1

 private:
  static std::size_t laneOf(const Window& window) {
    return static_cast<std::size_t>(window.column % Strip::kColumns);
  }
};

}  // namespace hearth
