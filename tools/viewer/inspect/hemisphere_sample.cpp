#include "viewer/inspect/hemisphere_sample.h"

#include <algorithm>
#include <cmath>

#include "level/locate.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "truth/truth_light.h"
#include "viewer/inspect/inspect.h"

namespace hearth {

namespace {

/// Degrees. Turned on by so much each time, directions never fall in line.
constexpr double kGoldenAngle = 137.50776405003785;

/// Unit vectors over the half of a sphere that has `pole` in its middle, evenly spread on a spiral.
std::vector<Vec3> directionsRound(Vec3 pole) {
  const Vec3 aside = std::abs(pole.z) < 0.5 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 right = 1 / length(cross(pole, aside)) * cross(pole, aside);
  const Vec3 up = cross(right, pole);
  std::vector<Vec3> directions;
  for (int i = 0; i < kHemisphereRays; ++i) {
    const double along = (i + 0.5) / kHemisphereRays;
    const double across = std::sqrt(1 - along * along);
    const auto [sin, cos] = sinCosDegrees(i * kGoldenAngle);
    directions.push_back(along * pole + across * (cos * right + sin * up));
  }
  return directions;
}

}  // namespace

HemisphereSample::HemisphereSample(const Scene& scene, const TruthMeshes& meshes,
                                   const SurfacePoint& place)
    : scene_(scene), meshes_(meshes) {
  const Vec3 eye = place.point + kAuthorNoise * place.normal;
  if (!contains(scene, scene[place.sector], eye, 0)) return;
  for (const Vec3 direction : directionsRound(place.normal)) {
    const auto met = trace(scene.level(), place.sector, eye, direction, RayKind::Look);
    if (met && !isSky(met->kind)) seen_.push_back(*met);
  }
}

bool HemisphereSample::isLitBy(const LightSource& light) const {
  const auto lightsAny = [&](const auto& source) {
    return std::ranges::any_of(seen_, [&](const SurfacePoint& place) {
      const double level = light.brightnessAt(place.point);
      return level * light.greatestFactor() >= kVisibleLevel && source.seenFraction(place) > 0;
    });
  };
  if (light.sun) {
    const Sun point(light.sun->angle(), light.sun->pitch(), 0);
    return lightsAny(TruthSun(scene_.level(), meshes_, point, 1));
  }
  LightSource point = light;
  point.radius = 0;
  return lightsAny(TruthSource(scene_.level(), meshes_, point, 1));
}

}  // namespace hearth
