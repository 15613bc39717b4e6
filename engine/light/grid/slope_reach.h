#pragma once

#include "level/scene.h"

namespace hearth {

/// Whether a slope of the sector comes to a height, or within rounding of it: there it may stop
/// what goes through a flat portal at this height.
bool hasSlopeAt(const Scene& scene, const Sector& sector, double z);

}  // namespace hearth
