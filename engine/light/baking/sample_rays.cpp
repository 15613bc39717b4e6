#include "light/baking/sample_rays.h"

#include <algorithm>
#include <cmath>

#include "math/tolerance.h"

namespace hearth {

bool isInFront(const Scene& scene, const LightReach& reach, std::size_t index,
               const LitSurface& surface) {
  const LightSource& light = scene.lights()[index];
  if (light.isArea()) return true;
  if (light.sun)
    return dot(surface.normal, light.sun->direction()) >
           kInPlaneSine - (reach.isSoft(index) ? light.sun->sinRadius() : 0);
  const double distance = surface.distanceInFront(light.position);
  return std::abs(distance) > kInPlane && distance > -reach.radius(index);
}

bool SampleRays::canShineOn(std::size_t index, SurfaceId surface) const {
  return surface == id_ ||
         isInFront(scene_, visibilities_.reach, index, *surfaces_[surface.index()]);
}

double SampleRays::seenFraction(const LightVisibility& visibility, std::size_t light,
                                const SamplePoint& at, const KnownRays* known) {
  return seenFractionBy(visibility, light, at, known);
}

double SampleRays::seenFraction(const SunVisibility& sun, std::size_t light, const SamplePoint& at,
                                const KnownSkyRays* known) {
  return seenFractionBy(sun, light, at, known);
}

template <typename Visibility, typename Known>
double SampleRays::seenFractionBy(const Visibility& visibility, std::size_t index,
                                  const SamplePoint& at, const Known* known) {
  if (!canShineOn(index, at.surface)) return 0;
  const LitSurface& there = *surfaces_[at.surface.index()];
  LightCost& cost = costs_[index];
  ++cost.samples;
  if (!isInReach(index, at)) return 0;
  const LightTarget target{at.target, scene_[at.surface].sector, {there.anchor, there.normal}};
  const double seen = known
                          ? visibility.seenFraction(target, known->shaft, known->outcome, cost.rays)
                          : visibility.seenFraction(target, cost.rays, enteredSectors(index));
  if (seen > 0) ++cost.seenSamples;
  return seen;
}

double SampleRays::unoccludedFraction(std::size_t light, const SamplePoint& at) {
  if (!isInReach(light, at)) return 0;
  ++costs_[light].seenSamples;
  return 1;
}

bool SampleRays::isAllInReach(std::size_t index, const TargetBox& targets) const {
  // Rays arrive less than this from samples, and rounding is less.
  constexpr double kBeside = 1e-3;  // metres
  const double most = reach(index) - kBeside;
  const auto isNear = [&](Vec3 corner) {
    const Vec3 toLight = light(index).position - corner;
    return dot(toLight, toLight) < most * most;
  };
  return most > 0 && std::ranges::all_of(targets.corners(), isNear) &&
         visibilities_.reach.isAllInSpot(index, targets.corners(), kBeside);
}

bool SampleRays::isInReach(std::size_t index, const SamplePoint& at) const {
  const Vec3 toLight = light(index).position - at.point;
  return dot(toLight, toLight) < reach(index) * reach(index) &&
         visibilities_.reach.isInSpot(index, at.point);
}

}  // namespace hearth
