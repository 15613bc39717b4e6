#pragma once

#include <optional>
#include <variant>

#include "math/vec.h"
#include "render/camera.h"
#include "viewer/overlay/automap.h"
#include "viewer/overlay/pointer.h"

namespace hearth {

/// How the pixels of a picture and points of the world belong together: as the camera sees them, or
/// on the map.
class MarkerSpace {
 public:
  explicit MarkerSpace(const Camera& camera) : space_(Projection(camera, camera.eye)) {}
  explicit MarkerSpace(const MapScale& map) : space_(map) {}

  /// Perhaps beside the picture; none behind the eye.
  std::optional<Vec2> pixelOf(Vec3 world) const;

  /// Where what is at `from` comes to when it is dragged to a pixel: at the same depth, as far as
  /// the camera looks level, or at the same height on the map. With an axis along that alone, as
  /// far as the pixel lies along it in the picture. Changed coordinates are whole millimetres.
  Vec3 dragged(Vec3 from, Vec2 pixel, std::optional<Axis> axis = {}) const;

  /// Where what is infinitely far away stands in the picture: none on the map.
  std::optional<Vec2> pixelTowards(Vec3 direction) const;
  /// What is seen at a pixel, of any length. Expects: not the map.
  Vec3 directionAt(Vec2 pixel) const;

  bool isMap() const { return std::holds_alternative<MapScale>(space_); }

 private:
  std::variant<Projection, MapScale> space_;
};

}  // namespace hearth
