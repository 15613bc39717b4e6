#pragma once

#include <algorithm>

#include "math/tolerance.h"
#include "truth/trace.h"

namespace hearth {

/// Metres. What two depths before the camera may differ by and still be equal.
inline double depthTie(double depth) { return std::max(kNearTie * depth, kPositionSlack); }

/// Whether a depth lies in a stretch of air whose ray goes 1 m deep, its ends included.
inline bool isIn(const AirStretch& stretch, double depth) {
  const double tie = depthTie(depth);
  return depth >= stretch.tEnter - tie && depth <= stretch.tLeave + tie;
}

/// Whether the later of two things hides the earlier one, at these depths.
inline bool hides(double later, double earlier) { return later <= earlier + depthTie(later); }

}  // namespace hearth
