#pragma once

#include "level/level.h"

namespace hearth {

/// Whether a slope of the sector comes to a height, or within rounding of it: there it may stop
/// what goes through a flat portal at this height.
bool hasSlopeAt(const Level& level, const Sector& sector, double z);

}  // namespace hearth
