#pragma once

#include <limits>

#include "level/level.h"

namespace hearth {

/// Metres. The body keeps so far off what stops it, stands as much above nothing, and takes heights
/// that differ by less for equal: the slack that positions have.
inline constexpr double kSkin = 1e-6;

/// Rise per metre. Steeper floors stop a walk up; 1 is 45 degrees.
inline constexpr double kSteepestWalk = 1;

inline constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// The cylinder of the level's player, in metres.
struct Body {
  double radius;
  double height;     ///< as low as the body crouches now
  double eyeHeight;  ///< above the feet, likewise
  double step;       ///< what the body climbs
};

/// `crouch` is Walker's: 0 standing .. 1 crouching. Both heights shrink alike.
Body bodyOf(const Level& level, double crouch);

}  // namespace hearth
