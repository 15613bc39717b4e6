#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/scene.h"
#include "render/camera.h"
#include "render/segment_columns.h"

namespace hearth {

/// A segment whose front covers columns of the screen.
struct SegmentFront {
  SegmentId segment;
  bool hasLevelAir;     ///< no height changes along it, so it shows the same in all its columns
  ColumnRange columns;  ///< not empty
  SegmentMeetings meetings;
};

/// The fronts of the sectors in view, each sector's found once in a frame, however many viewports
/// show it. Takes memory for these sectors alone, and keeps it from frame to frame.
class SegmentFronts {
 public:
  /// Forgets all sectors.
  void clear();

  bool has(SectorId sector) const { return indexOf(sector) != kFree; }

  /// Finds those of another sector that cover some of these columns of a screen that is so wide.
  void find(const Scene& scene, const Projection& projection, SectorId sector, int width,
            ColumnRange columns);

  /// Those of a sector for which they have been found. Valid until `find` is called again.
  std::span<const SegmentFront> of(SectorId sector) const {
    const Found& found = sectors_[indexOf(sector)];
    return std::span(fronts_).subspan(found.begin, found.end - found.begin);
  }

 private:
  static constexpr std::uint32_t kFree = ~std::uint32_t{0};

  struct Found {
    SectorId sector;
    std::uint32_t begin;  ///< its fronts are [begin, end)
    std::uint32_t end;
  };

  /// An index into sectors_, or kFree.
  std::uint32_t indexOf(SectorId sector) const;
  void add(const Found& found);
  void enter(std::uint32_t index);

  std::vector<SegmentFront> fronts_;
  std::vector<Found> sectors_;
  /// A hash table of indices into sectors_, a power of two in size and at most half full.
  std::vector<std::uint32_t> table_ = std::vector<std::uint32_t>(64, kFree);
};

}  // namespace hearth
