#pragma once

#include "truth/trace.h"

namespace hearth {

struct Ray {
  Vec3 origin;
  Vec3 direction;
  RayKind kind;
  /// A point so far along the ray in plan that rounding it turns the ray by no more than the
  /// rounding of `direction`. Exact predicates use it for the ray. The origin for vertical rays.
  Vec2 farPoint;
  /// Of light: the segment whose masked middle texture it is to arrive at, whether or not that has
  /// a hole there.
  std::optional<SegmentId> litMaskedMiddle = std::nullopt;

  Vec3 at(double t) const { return origin + t * direction; }
};

Ray makeRay(Vec3 origin, Vec3 direction, RayKind kind);

}  // namespace hearth
