#pragma once

#include "truth/trace.h"

namespace hearth {

struct Ray {
  Vec3 origin;
  Vec3 direction;
  RayKind kind;
  /// A point so far along the ray on the map that rounding it does not turn the ray by more than
  /// direction's own rounding: what exact predicates take for the ray. The origin for vertical
  /// rays.
  Vec2 farPoint;

  Vec3 at(double t) const { return origin + t * direction; }
};

Ray makeRay(Vec3 origin, Vec3 direction, RayKind kind);

}  // namespace hearth
