#pragma once

#include "level/level.h"

namespace hearth {

/// Whether a middle texture is solid, and no hole, at a point of its plane between its heights.
bool isSolidAt(const Level& level, const Surface& middle, Vec3 point);

}  // namespace hearth
