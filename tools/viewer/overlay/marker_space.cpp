#include "viewer/overlay/marker_space.h"

#include <algorithm>
#include <cmath>

#include "viewer/edit/lights_edit.h"

namespace hearth {

namespace {

/// What is nearer to the eye than this is not shown: it would jump about.
constexpr double kNearest = 0.1;  // metres

/// Of the depth of what is dragged: a step from which to see where an axis runs.
constexpr double kFractionOfDepth = 1e-4;

/// Pixels per metre that an axis has at least when something is dragged along it, as a fraction of
/// those across the picture.
constexpr double kLeastSpeed = 0.25;

/// Less than half a millimetre is no drag, so that the file's spelling stays.
double draggedTo(double from, double to) {
  const double rounded = toMillimetres(to);
  return rounded == toMillimetres(from) ? from : rounded;
}

Vec3 draggedOnMap(const MapScale& map, Vec3 from, Vec2 pixel, std::optional<Axis> axis) {
  const Vec2 plan = map.toWorld(pixel);
  const bool isXFree = !axis || axis == Axis::X;
  const bool isYFree = !axis || axis == Axis::Y;
  return {isXFree ? plan.x : from.x, isYFree ? plan.y : from.y, from.z};
}

std::optional<Vec2> pixelIn(const Projection& view, Vec3 world) {
  const CameraPoint point = view.toCamera(world.xy());
  if (point.depth < kNearest) return std::nullopt;
  return Vec2{view.columnOf(point), view.rowOf(world.z, point.depth)};
}

/// Where the axis runs in the picture, the pointer and what it drags go along it at one speed;
/// where it runs away from the eye, what is dragged does not fly off.
Vec3 draggedAlong(Vec3 axis, const Projection& view, Vec3 from, Vec2 pixel) {
  const double step = kFractionOfDepth * view.toCamera(from.xy()).depth;
  const Vec3 aside{-view.direction().y, view.direction().x, 0};
  const auto begin = pixelIn(view, from);
  const auto end = pixelIn(view, from + step * axis);
  const auto beside = pixelIn(view, from + step * aside);
  if (!begin || !end || !beside) return from;
  const Vec2 perMetre = 1 / step * (*end - *begin);
  const double across = length(*beside - *begin) / step;
  const double pixels = length(perMetre);
  if (pixels == 0) return from;
  const double along = dot(1 / pixels * perMetre, pixel - *begin);
  return from + along / std::max(pixels, kLeastSpeed * across) * axis;
}

Vec3 draggedInView(const Projection& view, Vec3 from, Vec2 pixel, std::optional<Axis> axis) {
  if (axis == Axis::X) return draggedAlong({1, 0, 0}, view, from, pixel);
  if (axis == Axis::Y) return draggedAlong({0, 1, 0}, view, from, pixel);
  const double depth = view.toCamera(from.xy()).depth;
  const double z = view.eye().z + depth * view.raySlopeAt(pixel.y);
  const Vec2 plan = axis ? from.xy() : view.eye().xy() + depth * view.rayOf(pixel.x);
  return {plan.x, plan.y, z};
}

}  // namespace

std::optional<Vec2> MarkerSpace::pixelOf(Vec3 world) const {
  if (const auto* map = std::get_if<MapScale>(&space_)) return map->toPicture(world.xy());
  return pixelIn(std::get<Projection>(space_), world);
}

std::optional<Vec2> MarkerSpace::pixelTowards(Vec3 direction) const {
  if (isMap()) return std::nullopt;
  constexpr double kFar = 1e6;  // metres: what is that far away stands still as the eye moves
  const auto& view = std::get<Projection>(space_);
  return pixelIn(view, view.eye() + kFar * direction);
}

Vec3 MarkerSpace::directionAt(Vec2 pixel) const {
  const auto& view = std::get<Projection>(space_);
  const Vec2 ray = view.rayOf(pixel.x);
  return {ray.x, ray.y, view.raySlopeAt(pixel.y)};
}

Vec3 MarkerSpace::dragged(Vec3 from, Vec2 pixel, std::optional<Axis> axis) const {
  Vec3 to = from;
  if (const auto* map = std::get_if<MapScale>(&space_))
    to = draggedOnMap(*map, from, pixel, axis);
  else
    to = draggedInView(std::get<Projection>(space_), from, pixel, axis);
  return {draggedTo(from.x, to.x), draggedTo(from.y, to.y), draggedTo(from.z, to.z)};
}

}  // namespace hearth
