#pragma once

#include <span>

#include "walk/surroundings.h"

namespace hearth {

struct Slide {
  Vec2 displacement;      ///< from where it began, in metres
  bool collided = false;  ///< whether it met a blocker on the way
};

/// Moves a disc of `radius` from the origin by `motion`. It slides along what stops it. The disc
/// keeps `radius` from every blocker. If it begins nearer to one, it comes no nearer.
Slide slideAlong(std::span<const Blocker> blockers, Vec2 motion, double radius);

}  // namespace hearth
