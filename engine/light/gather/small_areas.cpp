#include "light/gather/small_areas.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "math/hash.h"
#include "math/trig.h"

namespace hearth {

namespace {

Box3 boxOf(const Segment& segment, const SurfaceGeometry& wall) {
  Box3 box;
  for (const double z : {wall.zBottom, wall.zTop})
    for (const Vec2 p : {segment.p0, segment.p1}) box.add(Vec3{p.x, p.y, z});
  return box;
}

/// Those of a box that a point is outside of on the map; none if they are `widest` or more.
std::optional<CompassInterval> directionsTo(const Box3& box, Vec3 point, double widest) {
  constexpr double kPerRadian = 180 / std::numbers::pi;
  const Vec2 middle = 0.5 * (box.min.xy() + box.max.xy()) - point.xy();
  double from = 0;
  double to = 0;
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.max.y}) {
      const Vec2 corner = Vec2{x, y} - point.xy();
      const double ahead = dot(middle, corner);
      if (ahead <= 0) return std::nullopt;
      const double angle = kPerRadian * hearth::atan(cross(middle, corner) / ahead);
      from = std::min(from, angle);
      to = std::max(to, angle);
    }
  if (to - from >= widest) return std::nullopt;
  return CompassInterval{wrappedDegrees(compassDegrees(middle) + from), to - from};
}

}  // namespace

SmallAreas::SmallAreas(const Scene& scene, const AreaLights& lights) {
  const Level& level = scene.level();
  if (!lights.haveEmitters()) return;
  for (const SurfaceId id : scene.shownSurfaces()) {
    if (!canShine(scene[id].kind)) continue;
    if (scene[id].kind == SurfaceKind::Mesh)
      addFaces(level, lights, level.meshOf(id));
    else if (const auto light = lights.ofTexture(scene[id].mapping.texture))
      addSurface(scene, id, *light);
  }
}

void SmallAreas::addSurface(const Scene& scene, SurfaceId id, AreaLights::Place light) {
  const Surface& surface = scene[id];
  if (surface.segment) {
    const Segment& segment = scene[*surface.segment];
    const SurfaceGeometry& wall = scene.geometryOf(id);
    shining_.push_back({light, boxOf(segment, wall), segment.length * (wall.zTop - wall.zBottom)});
    return;
  }
  const Sector& sector = scene[surface.sector];
  const auto& slope = facesDown(surface.kind) ? sector.ceilingSlope : sector.floorSlope;
  const auto heightAt = [&](Vec2 p) {
    return facesDown(surface.kind) ? scene.airTop(sector, p) : scene.airBottom(sector, p);
  };
  Box3 box;
  for (const double x : {sector.box.min.x, sector.box.max.x})
    for (const double y : {sector.box.min.y, sector.box.max.y})
      box.add(Vec3{x, y, heightAt({x, y})});
  const Vec2 size = sector.box.max - sector.box.min;
  const Vec2 gradient = slope ? slope->gradient : Vec2{};
  shining_.push_back({light, box, size.x * size.y * std::sqrt(1 + dot(gradient, gradient))});
}

/// Those of one light together.
void SmallAreas::addFaces(const Level& level, const AreaLights& lights, const Mesh& mesh) {
  std::map<AreaLights::Place, Shining> found;
  for (const MeshFace& face : level.facesOf(mesh)) {
    const auto light = lights.ofTexture(face.texture);
    if (!light) continue;
    Shining& all = found.try_emplace(*light, Shining{*light, {}, 0}).first->second;
    for (const Vec3 corner : face.corners) all.box.add(corner);
    all.area += length(frontOf(face)) / 2;
  }
  for (const auto& [light, faces] : found) shining_.push_back(faces);
}

void SmallAreas::findAround(Vec3 point, double widest, std::span<const double> least,
                            std::vector<CompassInterval>& found) const {
  for (const auto& [light, box, area] : shining_) {
    const Vec3 toBox = box.vectorFrom(point);
    // Of a surface that is seen from straight before it, in the point's zenith.
    if (area <= least[light] * std::numbers::pi * dot(toBox, toBox)) continue;
    if (const auto directions = directionsTo(box, point, widest)) found.push_back(*directions);
  }
}

void SmallAreas::addTo(Hash& hash) const {
  for (const auto& [light, box, area] : shining_) {
    hash.addWhole(light);
    hash.addPoint(box.min);
    hash.addPoint(box.max);
    hash.addReal(area);
  }
}

}  // namespace hearth
