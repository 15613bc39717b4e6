#pragma once

#include <span>

#include "walk/surroundings.h"

namespace hearth {

struct Slide {
  Vec2 moved;               ///< from the centre, in metres
  bool wasStopped = false;  ///< by something on the way
};

/// Moves a disc of `radius` from the centre (the origin) by `motion`, sliding along what stops it.
/// It never passes a blocker, and never comes nearer to one than `radius`, or than it was.
Slide slideAlong(std::span<const Blocker> blockers, Vec2 motion, double radius);

}  // namespace hearth
