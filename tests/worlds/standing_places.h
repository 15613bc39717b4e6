#pragma once

#include <cstdint>
#include <vector>

#include "level/level.h"
#include "settings/options.h"

namespace hearth::worlds {

/// The player's own view, and views from `count` places where the player's body has room. The same
/// for the same seed on every machine. Fewer where there is hardly room.
std::vector<Shot> standingPlaces(const Level& level, std::size_t count, std::uint64_t seed,
                                 ImageSize size);

}  // namespace hearth::worlds
