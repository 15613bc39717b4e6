#pragma once

#include "math/vec.h"

namespace hearth {

struct Plane {
  Vec3 point;
  Vec3 normal;  ///< unit
  /// Metres in front of the plane.
  double inFront(Vec3 p) const { return dot(p - point, normal); }
};

}  // namespace hearth
