#pragma once

#include <vector>

#include "level/level.h"

namespace hearth::worlds {

/// By sector: whether the player may come to it from where it starts, if every mover whose switches
/// and crossings it comes to may stand at either end. Heights and steps count; breadths and
/// distances do not, nor do leaps.
std::vector<bool> reachedSectors(const Level& level);

/// Whether what is on the walls of a sector can be used from it or from a sector beside it.
bool mayUseWallsOf(const Level& level, SectorId sector, const std::vector<bool>& isReached);

}  // namespace hearth::worlds
