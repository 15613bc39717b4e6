#include "light/gather/small_areas.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "light/sectors_of_meshes.h"
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

/// Radians of the compass: what is narrower gives less than these fractions of any light, even
/// straight before a wall and at all heights. That is half of the width.
double narrowestFor(std::span<const double> fractions) {
  constexpr double kMost = 0.1;
  return std::min(kMost, 2 * std::ranges::min(fractions));
}

/// At least 90 if it is that wide.
double degreesIn(const Wedge& wedge) {
  const double ahead = dot(wedge.right, wedge.left);
  if (ahead <= 0) return 90;
  return 180 / std::numbers::pi * hearth::atan(cross(wedge.right, wedge.left) / ahead);
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

SmallAreas::SmallAreas(const Scene& scene, const AreaLights& lights) : sky_(lights.sky()) {
  std::vector<Shining> shining;
  if (lights.haveEmitters()) addShining(scene, lights, shining);
  if (sky_ || !shining.empty()) view_.emplace(scene);
  shining_ = std::make_shared<const std::vector<Shining>>(std::move(shining));
}

void SmallAreas::addShining(const Scene& scene, const AreaLights& lights,
                            std::vector<Shining>& shining) {
  const Level& level = scene.level();
  const std::vector<std::vector<SectorId>> sectors = sectorsOfMeshes(level);
  for (const SurfaceId id : scene.shownSurfaces()) {
    if (!canShine(scene[id].kind)) continue;
    if (scene[id].kind == SurfaceKind::Mesh)
      addFaces(level, lights, level.meshOf(id), sectors[level.meshIndexOf(id)], shining);
    else if (const auto light = lights.ofTexture(scene[id].mapping.texture))
      addSurface(scene, id, *light, shining);
  }
}

void SmallAreas::addSurface(const Scene& scene, SurfaceId id, AreaLights::Place light,
                            std::vector<Shining>& shining) {
  const Surface& surface = scene[id];
  if (surface.segment) {
    const Segment& segment = scene[*surface.segment];
    const SurfaceGeometry& wall = scene.geometryOf(id);
    shining.push_back({light,
                       {surface.sector},
                       boxOf(segment, wall),
                       segment.length * (wall.zTop - wall.zBottom)});
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
  shining.push_back(
      {light, {surface.sector}, box, size.x * size.y * std::sqrt(1 + dot(gradient, gradient))});
}

/// Those of one light together.
void SmallAreas::addFaces(const Level& level, const AreaLights& lights, const Mesh& mesh,
                          const std::vector<SectorId>& sectors, std::vector<Shining>& shining) {
  std::map<AreaLights::Place, Shining> found;
  for (const MeshFace& face : level.facesOf(mesh)) {
    const auto light = lights.ofTexture(face.texture);
    if (!light) continue;
    Shining& all = found.try_emplace(*light, Shining{*light, sectors, {}, 0}).first->second;
    for (const Vec3 corner : face.corners) all.box.add(corner);
    all.area += length(frontOf(face)) / 2;
  }
  for (const auto& [light, faces] : found) shining.push_back(faces);
}

void SmallAreas::findAround(const SliceStart& from, double widest, std::span<const double> least,
                            std::vector<CompassInterval>& found, SectorSet* met) {
  candidates_.clear();
  for (const Shining& shining : *shining_) {
    const Vec3 toBox = shining.box.vectorFrom(from.point);
    // Of a surface that is seen from straight before it, in the point's zenith.
    if (shining.area <= least[shining.light] * std::numbers::pi * dot(toBox, toBox)) continue;
    if (const auto directions = directionsTo(shining.box, from.point, widest))
      candidates_.push_back({&shining, *directions});
  }
  if (candidates_.empty() && !sky_) return;
  view_->lookFrom(from.point.xy(), from.sector, narrowestFor(least), met);
  for (const auto& [shining, directions] : candidates_) {
    const Box onMap{shining->box.min.xy(), shining->box.max.xy()};
    if (std::ranges::any_of(shining->sectors,
                            [&](SectorId its) { return view_->maySee(its, onMap); }))
      found.push_back(directions);
  }
  if (!sky_) return;
  // Skies are wide, but may be seen through what is narrow.
  for (const Wedge& window : view_->windows()) {
    const double width = degreesIn(window);
    if (width < widest) found.push_back({wrappedDegrees(compassDegrees(window.right)), width});
  }
}

void SmallAreas::addTo(Hash& hash) const {
  for (const Shining& shining : *shining_) {
    hash.addWhole(shining.light);
    hash.addPoint(shining.box.min);
    hash.addPoint(shining.box.max);
    hash.addReal(shining.area);
  }
}

}  // namespace hearth
