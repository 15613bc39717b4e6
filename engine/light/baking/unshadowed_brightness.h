#pragma once

#include <algorithm>

#include "level/light_source.h"
#include "math/vec.h"

namespace hearth {

/// The light at a point of a surface that sees all of the source (of the sky as much as level
/// ground can, whatever `lambert` says, for the cosine is a part of what it sees): in levels,
/// before colour. `reach` in metres, beyond which there is none; 0 of a light without a place that
/// is left out.
inline double unshadowedBrightness(const LightSource& light, double reach, Vec3 point, Vec3 normal,
                                   bool lambert) {
  if (!light.hasPlace()) {
    if (reach == 0) return 0;
    if (light.isArea()) return light.intensity;
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
