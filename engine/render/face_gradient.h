#pragma once

#include <array>

#include "math/vec.h"

namespace hearth {

/// A number that changes evenly along the plane of a face, as u and v do.
struct FaceGradient {
  double atEye = 0;  ///< continued from the plane, straight to the eye
  Vec3 perMetre;
};

/// Of what has these values at the corners of a face, whose area is not 0.
inline FaceGradient gradientOf(const std::array<Vec3, 3>& corners, Vec3 eye,
                               const std::array<double, 3>& values) {
  const Vec3 edge1 = corners[1] - corners[0];
  const Vec3 edge2 = corners[2] - corners[0];
  const Vec3 normal = cross(edge1, edge2);
  const Vec3 perMetre =
      (1 / dot(normal, normal)) * ((values[1] - values[0]) * cross(edge2, normal) +
                                   (values[2] - values[0]) * cross(normal, edge1));
  return {values[0] + dot(perMetre, eye - corners[0]), perMetre};
}

}  // namespace hearth
