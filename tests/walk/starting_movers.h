#pragma once

#include "level/level.h"
#include "random_levels/random.h"

namespace hearth::random_walks {

/// Lets something start each mover of a level: a trigger of any kind, walls that are used and
/// portals that are crossed. Some return at once, some after a while, and some never.
void letStart(Level& level, random_levels::Random& random);

}  // namespace hearth::random_walks
