#pragma once

#include <optional>
#include <vector>

#include "level/level.h"

namespace hearth {

/// Finds segments by sector and end points, in sectors to which some wall leads. Valid as long as
/// the level's segments are not moved.
class TwinIndex {
 public:
  explicit TwinIndex(const Level& level);

  /// The segment of `next` with the same two end points, the other way round.
  std::optional<SegmentId> find(const Segment& segment, SectorId next) const;

 private:
  const Level& level_;
  std::vector<SegmentId> sorted_;
};

}  // namespace hearth
