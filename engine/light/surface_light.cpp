#include "light/surface_light.h"

#include <algorithm>
#include <cmath>

#include "math/planted_bug.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Whether any of the light can shine on the plane of the surface. Of a ball that can be a part,
/// but none where its middle lies in the plane.
bool isInFront(const LightSource& light, const LitSurface& surface) {
  const double distance = surface.distanceInFront(light.position);
  if (planted(PlantedBug::LightInPlaneShines)) return distance > -kInPlane - light.radius;
  return std::abs(distance) > kInPlane && distance > -light.radius;
}

}  // namespace

SurfaceLight::SurfaceLight(const Level& level, const LitSurfaces& surfaces,
                           const LightSights& sights, bool lambert, SurfaceId id)
    : level_(level),
      surfaces_(surfaces),
      sights_(sights),
      surface_(*surfaces[id.index()]),
      id_(id),
      lambert_(lambert),
      placement_(surfaces, id),
      costs_(level.lights.size()) {
  for (std::size_t i = 0; i < level.lights.size(); ++i)
    if (isInFront(level.lights[i], surface_)) facing_.push_back(i);
}

int SurfaceLight::channels() const {
  const auto isColored = [this](std::size_t i) { return light(i).isColored(); };
  return std::ranges::any_of(facing_, isColored) ? 3 : 1;
}

SamplePoint SurfaceLight::place(Vec2 texelPoint) const { return placement_.place(texelPoint); }

double SurfaceLight::seenShare(const LightSight& sight, std::size_t index, const SamplePoint& at) {
  const LitSurface& there = *surfaces_[at.surface.index()];
  // What continues a surface may lie a tolerance off its plane.
  if (at.surface != id_ && !isInFront(light(index), there)) return 0;
  const LightTarget target{at.target, level_[at.surface].sector, {there.anchor, there.normal}};
  LightCost& cost = costs_[index];
  const double seen = sight.seenShare(target, cost.rays);
  ++cost.samples;
  if (seen > 0) ++cost.seenSamples;
  return seen;
}

double SurfaceLight::fullLevel(std::size_t index, const SamplePoint& at) const {
  const Vec3 toLight = light(index).position - at.point;
  const double distance = length(toLight);
  const double level = light(index).levelAt(distance);
  if (!lambert_) return level;
  const Vec3 normal = planted(PlantedBug::CosineOfWrongNormal)
                          ? Vec3{0, 0, 1}
                          : surfaces_[at.surface.index()]->normal;
  const double inFront = dot(toLight, normal);
  // The middle of a ball can lie behind a plane that a part of it lights.
  return level * std::max(0.0, inFront / distance);
}

}  // namespace hearth
