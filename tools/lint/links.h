#pragma once

#include <vector>

#include "level/level.h"

namespace hearth {

/// For each sector those that its walls and flat portals lead to, in order, each once.
std::vector<std::vector<SectorId>> linksOf(const Level& level);

/// The same without regard to their direction.
std::vector<std::vector<SectorId>> bothWays(const std::vector<std::vector<SectorId>>& links);

/// By sector, whether links lead to it from `start`, which counts.
std::vector<bool> reachedFrom(const std::vector<std::vector<SectorId>>& links, SectorId start);

/// The sectors that links lead to from `start`, which counts, without a way through `known` ones;
/// nothing from one of these.
std::vector<SectorId> gainedFrom(const std::vector<std::vector<SectorId>>& links, SectorId start,
                                 std::vector<bool> known);

/// The sectors of each part that hangs together by links that lead both ways, in order.
std::vector<std::vector<SectorId>> partsOf(const std::vector<std::vector<SectorId>>& links);

}  // namespace hearth
