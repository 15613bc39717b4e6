#pragma once

#include "level/scene.h"

namespace hearth {

/// Whether a slope of the sector reaches a height, within rounding. A slope there may stop rays
/// through a flat portal at this height.
bool hasSlopeAt(const Scene& scene, const Sector& sector, double z);

}  // namespace hearth
