#include "truth/truth_light.h"

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

}  // namespace

TruthLight::TruthLight(const Level& level) : level_(level) {
  for (const LightSource& light : level.lights) origins_.push_back(rayOrigin(level, light));
}

Vec3 TruthLight::at(const SurfacePoint& place) const {
  Vec3 sum;
  for (std::size_t i = 0; i < origins_.size(); ++i) {
    const LightSource& light = level_.lights[i];
    sum = sum + from(i, place) * Vec3{light.share(0), light.share(1), light.share(2)};
  }
  return sum;
}

double TruthLight::from(std::size_t index, const SurfacePoint& place) const {
  const LightSource& light = level_.lights[index];
  const Vec3 toLight = light.position - place.point;
  const double inFront = dot(place.normal, toLight);
  if (inFront <= kInPlane) return 0;
  // A straight line meets a plane once: where it meets this surface, it meets it at this point.
  const Vec3 origin = origins_[index];
  const std::optional<TruthHit> met =
      trace(level_, light.sector, origin, place.point - origin, RayKind::Light);
  if (!met || !isSameSurface(*met, place)) return 0;
  const double distance = length(toLight);
  return light.levelAt(distance) * (level_.bake.lambert ? inFront / distance : 1);
}

}  // namespace hearth
