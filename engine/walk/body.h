#pragma once

#include <limits>

#include "level/level.h"

namespace hearth {

/// Metres. The body keeps this distance from blockers, and treats heights that differ by less as
/// equal. It is the slack of positions.
inline constexpr double kSkin = 1e-6;

/// Rise per metre; 1 is 45 degrees. The body cannot walk up steeper floors.
inline constexpr double kSteepestWalk = 1;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The cylinder of the level's player, in metres.
struct Body {
  double radius;
  double height;      ///< as low as the body crouches now
  double eyeHeight;   ///< above the feet, likewise
  double stepHeight;  ///< the highest step that the body climbs
};

/// `crouch` is Walker's: 0 standing .. 1 crouching. Both heights shrink alike.
Body bodyOf(const Level& level, double crouch);

}  // namespace hearth
