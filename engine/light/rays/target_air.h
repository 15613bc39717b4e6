#pragma once

#include <span>

#include "level/scene.h"

namespace hearth {

/// Rays from a ball or point light to points of one surface.
struct TargetRays {
  Vec3 light;
  double radius;  ///< metres
  double reach;   ///< of the longest, metres
  double noise;   ///< metres by which rounding moves their ends
  double margin;  ///< metres, see rayMargin
};

/// Whether neither floor nor ceiling of the points' sector, slopes included, stops a ray before its
/// end. That is so if all points are away from them, or if the light is so far before them that
/// rounding does not matter.
bool isAirClear(const Scene& scene, const Sector& sector, const TargetRays& rays,
                std::span<const Vec3> points);

}  // namespace hearth
