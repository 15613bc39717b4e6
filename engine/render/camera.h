#pragma once

#include <algorithm>

#include "level/scene.h"
#include "math/round_up.h"
#include "math/trig.h"
#include "math/vec.h"

namespace hearth {

inline constexpr double kMaxPitch = 60;  // degrees, up and down: what the projection takes

struct Camera {
  SectorId sector;   ///< that contains `eye`
  Vec3 eye;          ///< metres, absolute
  double angle = 0;  ///< degrees, 0 along +x, 90 along +y
  double pitch = 0;  ///< degrees upwards, -60..60
  double fov = 90;   ///< degrees, horizontal, 1..179
  int width = 320;
  int height = 200;
  double seconds = 0;  ///< that animations of sprites have run

  friend bool operator==(const Camera&, const Camera&) = default;
};

inline Camera cameraOf(const Shot& shot) {
  return {shot.sector, shot.eye, shot.angle, shot.pitch, shot.fov, shot.width, shot.height, 0};
}

/// A point in plan as the camera sees it, in metres.
struct CameraPoint {
  double depth;    ///< along the view direction
  double lateral;  ///< to the right
};

/// World space -> camera space -> depth space (column, 1/depth) -> screen space. Columns and rows
/// are real numbers here; pixel (i, j) is sampled at its centre (i + 1/2, j + 1/2). Looking up and
/// down shears: it only moves the row of the horizon.
class Projection {
 public:
  /// `eye` is the camera's eye, moved off the walls that it may touch. A square of `pixelSize`
  /// pixels counts as one column and row.
  Projection(const Camera& camera, Vec3 eye, int pixelSize = 1)
      : eye_(eye),
        direction_{sinCosDegrees(camera.angle).cos, sinCosDegrees(camera.angle).sin},
        right_(turned90(direction_)),
        centerColumn_(camera.width / 2.0 / pixelSize),
        distancePx_(centerColumn_ / tanDegrees(camera.fov / 2)),
        horizonRow_(camera.height / 2.0 / pixelSize + distancePx_ * tanDegrees(camera.pitch)) {}

  Vec3 eye() const { return eye_; }
  Vec2 direction() const { return direction_; }
  double distancePx() const { return distancePx_; }
  double horizonRow() const { return horizonRow_; }

  CameraPoint toCamera(Vec2 world) const { return toCameraDirection(world - eye_.xy()); }
  /// From one point to another.
  CameraPoint toCameraDirection(Vec2 world) const {
    return {dot(world, direction_), dot(world, right_)};
  }
  /// The column of a point in front of the eye (depth > 0).
  double columnOf(CameraPoint p) const {
    return centerColumn_ + distancePx_ * (p.lateral / p.depth);
  }
  double rowOf(double z, double depth) const {
    return horizonRow_ - (z - eye_.z) * distancePx_ / depth;
  }
  /// The first of rows [begin, end) whose centre is not above height z at this depth, or `end`.
  int rowIn(int begin, int end, double z, double depth) const {
    const double row = rowOf(z, depth) - 0.5;
    return roundedUp(std::clamp(row, static_cast<double>(begin), static_cast<double>(end)));
  }
  /// How far the ray through a column goes to the right per metre of depth.
  double slantOf(double column) const { return (column - centerColumn_) / distancePx_; }
  /// The ray through a column in plan, of depth 1.
  Vec2 rayOf(double column) const { return direction_ + slantOf(column) * right_; }
  /// How far the ray through a row goes up per metre of depth.
  double raySlopeAt(double row) const { return (horizonRow_ - row) / distancePx_; }

 private:
  Vec3 eye_;
  Vec2 direction_;
  Vec2 right_;
  double centerColumn_;
  double distancePx_;  ///< of the picture plane, in pixels
  double horizonRow_;
};

}  // namespace hearth
