#pragma once

#include <algorithm>

#include "level/light_source.h"
#include "math/vec.h"

namespace hearth {

/// The light at a point of a surface that sees all of the source: in levels, before colour. `reach`
/// in metres, beyond which there is none; of a sun 0 if it is left out.
inline double unshadowedBrightness(const LightSource& light, double reach, Vec3 point, Vec3 normal,
                                   bool lambert) {
  if (light.sun) {
    if (reach == 0) return 0;
    return light.intensity * (lambert ? std::max(0.0, dot(light.sun->direction(), normal)) : 1);
  }
  const Vec3 toLight = light.position - point;
  const double distance = length(toLight);
  if (distance >= reach) return 0;
  const double level = light.brightnessAt(point);
  if (!lambert) return level;
  // The middle of a ball can lie behind a plane that a part of it lights.
  return level * std::max(0.0, dot(toLight, normal) / distance);
}

}  // namespace hearth
