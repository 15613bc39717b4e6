#include "truth/truth_light.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "level/locate.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "truth/gather_rays.h"

namespace hearth {

namespace {

/// The light moved off the walls and flats of its sector; beyond a sky there are only walls.
Vec3 rayOrigin(const Level& level, const LightSource& light) {
  const Sector& sector = level[light.sector];
  const Vec3 p = light.position;
  Vec3 origin = nudgedInside(level, sector, p);
  const bool isAboveSky = sector.ceiling.isSky && p.z > sector.ceiling.z;
  const bool isBelowSky = sector.floor.isSky && p.z < sector.floor.z;
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

SurfacePoint litSideOf(const Level& level, SurfacePoint place) {
  if (!place.face) return place;
  const Vec3 front = frontOf(level.meshFaces[*place.face]);
  place.normal = front == Vec3{} ? Vec3{} : (1 / length(front)) * front;  // none is never lit
  return place;
}

TruthSource::TruthSource(const Level& level, const TruthMeshes& meshes, const LightSource& light,
                         int ballPoints)
    : level_(level), meshes_(meshes), center_{rayOrigin(level, light), light.sector} {
  if (light.radius == 0) {
    origins_ = {center_};
    return;
  }
  count_ = 0;
  for (int i = 1; count_ < ballPoints; ++i) {
    const Vec3 p{spread(i, 2), spread(i, 3), spread(i, 5)};
    if (dot(p, p) > 1) continue;
    ++count_;
    const Vec3 point = center_.point + light.radius * p;
    if (const auto sector = sectorAt(level, light.sector, center_.point, point))
      origins_.push_back({point, *sector});
  }
}

double TruthSource::seenFraction(const SurfacePoint& place) const {
  const SurfacePoint lit = litSideOf(level_, place);
  const auto seen =
      std::ranges::count_if(origins_, [&](const AirPoint& origin) { return sees(origin, lit); });
  return static_cast<double>(seen) / count_;
}

double TruthSource::seenFraction(const AirPoint& place) const {
  const auto seen =
      std::ranges::count_if(origins_, [&](const AirPoint& origin) { return sees(origin, place); });
  return static_cast<double>(seen) / count_;
}

double TruthSource::unshaded(const LightSource& light, const SurfacePoint& place, bool lambert) {
  if (light.sun) {
    const double cosine = std::max(0.0, dot(place.normal, light.sun->direction()));
    return light.intensity * (lambert ? cosine : 1);
  }
  const Vec3 toLight = light.position - place.point;
  if (std::abs(dot(place.normal, toLight)) <= kInPlane) return 0;
  const double distance = length(toLight);
  const double cosine = lambert ? std::max(0.0, dot(place.normal, toLight)) / distance : 1;
  return light.brightnessAt(place.point) * cosine;
}

bool TruthSource::sees(const AirPoint& origin, const SurfacePoint& place) const {
  if (dot(place.normal, origin.point - place.point) <= kInPlane) return false;
  return arrivalAt(place, origin).arrives;
}

bool TruthSource::sees(const AirPoint& origin, const AirPoint& place) const {
  return sectorAt(level_, origin.sector, origin.point, place.point,
                  meshes_.shadowsOn(origin.point, place.point)) == place.sector;
}

TruthSource::Arrival TruthSource::arrivalAt(const SurfacePoint& place,
                                            const AirPoint& origin) const {
  const MeetInAir shadows = meshes_.shadowsOn(origin.point, place.point, place.face);
  if (place.mesh) {
    const auto end = traceLightToMesh(level_, origin.sector, origin.point, place.point, shadows);
    if (const TruthHit* hit = std::get_if<TruthHit>(&end)) return {false, *hit};
    return {meshes_.isIn(*place.mesh, std::get<SectorId>(end)), std::nullopt};
  }
  const std::optional<TruthHit> met =
      traceLight(level_, origin.sector, origin.point, place, shadows);
  // A straight line meets a plane once: where it meets this surface, it meets it at this point.
  if (met && isSameSurface(*met, place)) return {true, std::nullopt};
  return {false, met};
}

std::optional<TruthHit> TruthSource::firstMet(const SurfacePoint& place) const {
  std::optional<TruthHit> met = arrivalAt(place, center_).stop;
  for (std::size_t i = 0; i < origins_.size() && !met; ++i)
    met = arrivalAt(place, origins_[i]).stop;
  return met;
}

TruthSun::TruthSun(const Level& level, const TruthMeshes& meshes, const Sun& sun, int discPoints)
    : level_(level), meshes_(meshes) {
  const Vec3 middle = sun.direction();
  if (sun.size() == 0) {
    directions_ = {middle};
    return;
  }
  const Vec3 right = directionAt(sun.angle() - 90, 0);
  const Vec3 up = cross(middle, right);
  // Equal parts of a cosine are equal solid angles (Archimedes).
  const double least = sinCosDegrees(sun.size() / 2).cos;
  for (int i = 1; i <= discPoints; ++i) {
    const double cosine = std::lerp(least, 1.0, (spread(i, 2) + 1) / 2);
    const double sine = std::sqrt(1 - cosine * cosine);
    const auto [s, c] = sinCosDegrees(180 * spread(i, 3));
    directions_.push_back(cosine * middle + (sine * c) * right + (sine * s) * up);
  }
}

double TruthSun::seenFraction(const SurfacePoint& place) const {
  const SurfacePoint lit = litSideOf(level_, place);
  const GatherRays rays(level_, meshes_, lit);
  const auto seen = std::ranges::count_if(directions_, [&](Vec3 direction) {
    return dot(lit.normal, direction) > kInPlaneSine && rays.seesSky(direction);
  });
  return static_cast<double>(seen) / static_cast<double>(directions_.size());
}

double TruthSun::seenFraction(const AirPoint& place) const {
  const GatherRays rays(level_, meshes_, place.point, place.sector);
  const auto seen =
      std::ranges::count_if(directions_, [&](Vec3 direction) { return rays.seesSky(direction); });
  return static_cast<double>(seen) / static_cast<double>(directions_.size());
}

std::optional<TruthHit> TruthSun::firstMet(const SurfacePoint& place) const {
  const GatherRays rays(level_, meshes_, litSideOf(level_, place));
  for (const Vec3 direction : directions_) {
    const std::optional<TruthHit> met = rays.firstMet(direction);
    if (met && !isSky(met->kind)) return met;
  }
  return std::nullopt;
}

TruthLight::TruthLight(const Level& level, int ballPoints)
    : level_(level), meshes_(std::make_shared<TruthMeshes>(level)) {
  for (const LightSource& light : level.lights)
    if (light.sun)
      sources_.emplace_back(TruthSun(level, *meshes_, *light.sun, ballPoints));
    else if (!light.hasPlace())
      sources_.emplace_back(TruthOfNoDirection());
    else
      sources_.emplace_back(TruthSource(level, *meshes_, light, ballPoints));
}

template <typename Place>
Vec3 TruthLight::sumAt(const Place& place) const {
  Vec3 sum;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const LightSource& light = level_.lights[i];
    sum = sum +
          from(i, place) * Vec3{light.colorFactor(0), light.colorFactor(1), light.colorFactor(2)};
  }
  return sum;
}

Vec3 TruthLight::at(const SurfacePoint& place) const { return sumAt(place); }

Vec3 TruthLight::at(const AirPoint& place) const { return sumAt(place); }

double TruthLight::from(std::size_t light, const SurfacePoint& place) const {
  return unshaded(light, place) * seenFraction(light, place);
}

double TruthLight::from(std::size_t light, const AirPoint& place) const {
  const double seen =
      std::visit([&](const auto& source) { return source.seenFraction(place); }, sources_[light]);
  return level_.lights[light].brightnessAt(place.point) * seen;
}

double TruthLight::seenFraction(std::size_t light, const SurfacePoint& place) const {
  return std::visit([&](const auto& source) { return source.seenFraction(place); },
                    sources_[light]);
}

double TruthLight::unshaded(std::size_t light, const SurfacePoint& place) const {
  return TruthSource::unshaded(level_.lights[light], litSideOf(level_, place), level_.bake.lambert);
}

}  // namespace hearth
