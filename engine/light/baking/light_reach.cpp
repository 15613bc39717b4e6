#include "light/baking/light_reach.h"

#include <algorithm>
#include <cstdint>

#include "light/ray_error.h"

namespace hearth {

namespace {

/// What each light reaches, and a little more, so that no rounding leaves out anything.
std::vector<Box> boxesOnMap(std::span<const LightSource> lights, double cutOff) {
  constexpr double kEverywhere = 1e15;  // metres; in place of an endless reach
  std::vector<Box> boxes;
  for (const LightSource& light : lights) {
    const Vec2 p = light.position.xy();
    const double rounding = roundingOf(largestCoordinate(light.position));
    boxes.push_back(
        grown({p, p}, std::min(light.reach(cutOff), kEverywhere) + 2 * kAuthorNoise + rounding));
  }
  return boxes;
}

}  // namespace

LightReach::LightReach(std::span<const LightSource> lights, const BakeSettings& settings)
    : onMap_(boxesOnMap(lights, settings.cutOff)) {
  for (const LightSource& light : lights) {
    metres_.push_back(light.reach(settings.cutOff));
    radii_.push_back(settings.softSamples == 0 || !light.hasPlace() ? 0 : light.radius);
    areSoft_.push_back(radii_.back() > 0 || light.isArea() ||
                       (light.sun && light.sun->size() > 0 && settings.softSamples > 0));
    positions_.push_back(light.position);
    spots_.push_back(light.spot);
  }
}

bool LightReach::isInSpot(std::size_t spot, const Box3& box) const {
  const double radius = length(box.max - box.min) / 2;
  const Vec3 offset = 0.5 * (box.min + box.max) - positions_[spot];
  const double rounding = roundingOf(largestCoordinate(positions_[spot]) + length(offset));
  return spots_[spot]->beyondEdge(offset) <= radius + kAuthorNoise + rounding;
}

bool LightReach::isAllInSpot(std::size_t light, std::span<const Vec3> corners, double slack) const {
  const std::optional<Spot>& spot = spots_[light];
  if (!spot) return true;
  return spot->outer() <= 90 && std::ranges::all_of(corners, [&](Vec3 corner) {
           return spot->beyondEdge(corner - positions_[light]) < -slack;
         });
}

std::vector<std::size_t> LightReach::reaching(const Box3& box) const {
  constexpr std::size_t kFew = 32;
  std::vector<std::size_t> found;
  found.reserve(std::min(kFew, lights()));
  onMap_.query({box.min.xy(), box.max.xy()}, [&](std::uint32_t light) {
    if (reaches(light, box)) found.push_back(light);
  });
  std::ranges::sort(found);
  return found;
}

std::vector<std::size_t> LightReach::reaching(const Box3& box,
                                              std::span<const std::size_t> lights) const {
  std::vector<std::size_t> found;
  for (const std::size_t light : lights)
    if (reaches(light, box)) found.push_back(light);
  return found;
}

}  // namespace hearth
