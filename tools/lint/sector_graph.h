#pragma once

#include <span>
#include <vector>

#include "level/level.h"

namespace hearth {

/// For each sector the sectors that its walls and flat portals lead to, in order, each once.
std::vector<std::vector<SectorId>> sectorGraph(const Level& level);

/// The same without regard to their direction.
std::vector<std::vector<SectorId>> undirected(const std::vector<std::vector<SectorId>>& links);

/// By sector, whether links lead to it from `start`; `start` itself counts.
std::vector<bool> reachableFrom(const std::vector<std::vector<SectorId>>& links, SectorId start);

/// The sectors to which links lead from `start`, itself included, without passing `known` ones;
/// none if `start` is known.
std::vector<SectorId> newlyReachableFrom(const std::vector<std::vector<SectorId>>& links,
                                         SectorId start, std::vector<bool> known);

/// The sectors of each part that two-way links connect, in order.
std::vector<std::vector<SectorId>> connectedComponents(
    const std::vector<std::vector<SectorId>>& links);

/// Square metres on the map.
double areaOf(const Level& level, std::span<const SectorId> sectors);

/// Walls at which flats move.
class MovingWalls {
 public:
  explicit MovingWalls(const Level& level);

  /// Whether a flat moves in the segment's sector or in one that it leads to.
  bool has(const Segment& segment) const;

 private:
  std::vector<bool> isMoving_;  ///< by sector
};

}  // namespace hearth
