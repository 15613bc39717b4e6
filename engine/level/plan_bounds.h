#pragma once

#include "level/level.h"
#include "math/box.h"

namespace hearth {

/// The rectangle that a plan of the level has to show: around all sectors, except those that are
/// much larger than the rectangle around the lights, the shots and the player.
Box planBounds(const Level& level);

}  // namespace hearth
