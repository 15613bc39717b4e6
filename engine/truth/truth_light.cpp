#include "truth/truth_light.h"

#include <algorithm>
#include <cmath>

#include "level/locate.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// The light moved off the walls and flats of its sector; beyond a sky there are only walls.
Vec3 rayOrigin(const Level& level, const LightSource& light) {
  const Sector& sector = level[light.sector];
  const Vec3 p = light.position;
  Vec3 origin = nudgedInside(level, sector, p);
  const bool isAboveSky = sector.ceiling.parallax && p.z > sector.ceiling.z;
  const bool isBelowSky = sector.floor.parallax && p.z < sector.floor.z;
  if (isAboveSky || isBelowSky) origin.z = p.z;
  return origin;
}

/// The digits of the index to the base, mirrored behind the point: evenly spread in -1..1 (Halton).
double spread(int index, int base) {
  double value = 0;
  double digit = 1;
  for (; index > 0; index /= base) value += (digit /= base) * (index % base);
  return 2 * value - 1;
}

}  // namespace

TruthLight::TruthLight(const Level& level, int ballPoints) : level_(level) {
  for (const LightSource& light : level.lights) shapes_.push_back(shapeOf(light, ballPoints));
}

TruthLight::Shape TruthLight::shapeOf(const LightSource& light, int ballPoints) const {
  const Vec3 middle = rayOrigin(level_, light);
  if (light.radius == 0) return {{{middle, light.sector}}, 1};
  Shape ball{{}, 0};
  for (int i = 1; ball.count < ballPoints; ++i) {
    const Vec3 p{spread(i, 2), spread(i, 3), spread(i, 5)};
    if (dot(p, p) > 1) continue;
    ++ball.count;
    const Vec3 point = middle + light.radius * p;
    if (const auto sector = sectorAt(level_, light.sector, middle, point))
      ball.origins.push_back({point, *sector});
  }
  return ball;
}

Vec3 TruthLight::at(const SurfacePoint& place) const {
  Vec3 sum;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const LightSource& light = level_.lights[i];
    sum = sum + from(i, place) * Vec3{light.share(0), light.share(1), light.share(2)};
  }
  return sum;
}

double TruthLight::from(std::size_t index, const SurfacePoint& place) const {
  return unshaded(index, place) * seenShare(index, place);
}

double TruthLight::seenShare(std::size_t index, const SurfacePoint& place) const {
  const Shape& shape = shapes_[index];
  const auto seen = std::ranges::count_if(
      shape.origins, [&](const Origin& origin) { return sees(origin, place); });
  return static_cast<double>(seen) / shape.count;
}

double TruthLight::unshaded(std::size_t index, const SurfacePoint& place) const {
  const LightSource& light = level_.lights[index];
  const Vec3 toLight = light.position - place.point;
  if (std::abs(dot(place.normal, toLight)) <= kInPlane) return 0;
  const double distance = length(toLight);
  const double cosine =
      level_.bake.lambert ? std::max(0.0, dot(place.normal, toLight)) / distance : 1;
  return light.levelAt(distance) * cosine;
}

bool TruthLight::sees(const Origin& origin, const SurfacePoint& place) const {
  if (dot(place.normal, origin.point - place.point) <= kInPlane) return false;
  // A straight line meets a plane once: where it meets this surface, it meets it at this point.
  const std::optional<TruthHit> met = traceLight(level_, origin.sector, origin.point, place);
  return met && isSameSurface(*met, place);
}

}  // namespace hearth
