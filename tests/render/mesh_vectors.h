#pragma once

#include <cmath>

#include "math/vec.h"
#include "render/camera.h"

/// Numbers that hold for every renderer of triangles in perspective, worked out by hand from the
/// textbook's formulas (frustum matrix, look-at matrix, barycentric coordinates, Sutherland and
/// Hodgman's clipping), in Hearth's terms. A frustum's 1 - 1/w is 1/depth here, its vertical field
/// of view fixes the distance of the picture plane, and its axes (right, up, ahead) are y, z and x
/// of a camera that looks along +x.
namespace hearth::test {

inline constexpr double kPrinted = 1e-6;        // of numbers with six digits
inline constexpr double kPrintedPixels = 1e-4;  // of pixels, which have four
inline constexpr double kRadians = 3.14159265358979323846 / 180;

/// A point as textbooks have it: to the right, up, ahead.
inline Vec3 seen(double right, double up, double ahead) { return {ahead, right, up}; }

/// The horizontal field of view of a picture, from the vertical one; degrees.
inline double horizontalFov(double vertical, int width, int height) {
  return 2 / kRadians * std::atan(std::tan(kRadians * vertical / 2) * width / height);
}

inline Projection projectionOf(int width, int height, double fov) {
  return {Camera{SectorId(0), {}, 0, 0, fov, width, height, 0}, {}};
}
/// 60 degrees upright.
inline Projection frustum(int width, int height) {
  return projectionOf(width, height, horizontalFov(60, width, height));
}

/// Where a point of the world shows.
inline Vec2 pixelOf(const Projection& projection, Vec3 p) {
  const CameraPoint at = projection.toCamera(p.xy());
  return {projection.columnOf(at), projection.rowOf(p.z, at.depth)};
}

}  // namespace hearth::test
