#pragma once

#include <optional>
#include <span>

#include "math/vec.h"

namespace hearth {

/// z = zAtOrigin + gradient . ((x, y) - origin)
struct PlaneFit {
  double zAtOrigin;
  Vec2 gradient;
  double worstMiss;  ///< metres, upwards or downwards, over the points it was fitted to
};

/// The plane with the least squares of vertical distances to `points`. None when all of them lie
/// within `noise` metres of one line, seen from above.
std::optional<PlaneFit> fitPlane(std::span<const Vec3> points, Vec2 origin, double noise);

}  // namespace hearth
