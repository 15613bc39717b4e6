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

TruthSource::TruthSource(const Level& level, const LightSource& light, int ballPoints)
    : level_(level), center_{rayOrigin(level, light), light.sector} {
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
  const auto seen =
      std::ranges::count_if(origins_, [&](const AirPoint& origin) { return sees(origin, place); });
  return static_cast<double>(seen) / count_;
}

double TruthSource::seenFraction(const AirPoint& place) const {
  const auto seen =
      std::ranges::count_if(origins_, [&](const AirPoint& origin) { return sees(origin, place); });
  return static_cast<double>(seen) / count_;
}

double TruthSource::unshaded(const LightSource& light, const SurfacePoint& place, bool lambert) {
  const Vec3 toLight = light.position - place.point;
  if (std::abs(dot(place.normal, toLight)) <= kInPlane) return 0;
  const double distance = length(toLight);
  const double cosine = lambert ? std::max(0.0, dot(place.normal, toLight)) / distance : 1;
  return light.brightnessAt(distance) * cosine;
}

bool TruthSource::sees(const AirPoint& origin, const SurfacePoint& place) const {
  if (dot(place.normal, origin.point - place.point) <= kInPlane) return false;
  // A straight line meets a plane once: where it meets this surface, it meets it at this point.
  const std::optional<TruthHit> met = traceLight(level_, origin.sector, origin.point, place);
  return met && isSameSurface(*met, place);
}

bool TruthSource::sees(const AirPoint& origin, const AirPoint& place) const {
  return sectorAt(level_, origin.sector, origin.point, place.point) == place.sector;
}

std::optional<TruthHit> TruthSource::firstMet(const SurfacePoint& place) const {
  const auto metFrom = [&](const AirPoint& origin) -> std::optional<TruthHit> {
    std::optional<TruthHit> met = traceLight(level_, origin.sector, origin.point, place);
    return met && isSameSurface(*met, place) ? std::nullopt : met;
  };
  std::optional<TruthHit> met = metFrom(center_);
  for (std::size_t i = 0; i < origins_.size() && !met; ++i) met = metFrom(origins_[i]);
  return met;
}

TruthLight::TruthLight(const Level& level, int ballPoints) : level_(level) {
  for (const LightSource& light : level.lights) sources_.emplace_back(level, light, ballPoints);
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
  const LightSource& source = level_.lights[light];
  return source.brightnessAt(length(source.position - place.point)) *
         sources_[light].seenFraction(place);
}

double TruthLight::seenFraction(std::size_t light, const SurfacePoint& place) const {
  return sources_[light].seenFraction(place);
}

double TruthLight::unshaded(std::size_t light, const SurfacePoint& place) const {
  return TruthSource::unshaded(level_.lights[light], place, level_.bake.lambert);
}

}  // namespace hearth
