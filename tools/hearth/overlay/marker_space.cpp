#include "hearth/overlay/marker_space.h"

#include <cmath>

#include "hearth/edit/lights_edit.h"

namespace hearth {

namespace {

/// What is nearer to the eye than this is not shown: it would jump about.
constexpr double kNearest = 0.1;  // metres

/// Less than half a millimetre is no drag, so that the file's spelling stays.
double draggedTo(double from, double to) {
  const double rounded = toMillimetres(to);
  return rounded == toMillimetres(from) ? from : rounded;
}

}  // namespace

std::optional<Vec2> MarkerSpace::pixelOf(Vec3 world) const {
  if (const auto* map = std::get_if<MapScale>(&space_)) return map->toPicture(world.xy());
  const auto& view = std::get<Projection>(space_);
  const CameraPoint point = view.toCamera(world.xy());
  if (point.depth < kNearest) return std::nullopt;
  return Vec2{view.columnOf(point), view.rowOf(world.z, point.depth)};
}

Vec3 MarkerSpace::dragged(Vec3 from, Vec2 pixel, bool isUpright) const {
  Vec2 plan = from.xy();
  double z = from.z;
  if (const auto* map = std::get_if<MapScale>(&space_)) {
    plan = map->toWorld(pixel);
  } else {
    const auto& view = std::get<Projection>(space_);
    const double depth = view.toCamera(from.xy()).depth;
    if (!isUpright) plan = view.eye().xy() + depth * view.rayOf(pixel.x);
    z = view.eye().z + depth * view.climbOf(pixel.y);
  }
  return {draggedTo(from.x, plan.x), draggedTo(from.y, plan.y), draggedTo(from.z, z)};
}

}  // namespace hearth
