#pragma once

#include "level/level.h"

namespace hearth {

/// Whether a masked middle texture is solid, and no hole, at a point of its plane between its
/// heights.
bool isSolidAt(const Level& level, const Surface& maskedMiddle, Vec3 point);

}  // namespace hearth
