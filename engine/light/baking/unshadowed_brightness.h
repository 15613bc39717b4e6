#pragma once

#include <algorithm>

#include "level/light_source.h"
#include "math/vec.h"

namespace hearth {

/// The light at a point of a surface that sees all of the source: in levels, before colour. `reach`
/// in metres, beyond which there is none.
inline double unshadowedBrightness(const LightSource& light, double reach, Vec3 point, Vec3 normal,
                                   bool lambert) {
  const Vec3 toLight = light.position - point;
  const double distance = length(toLight);
  if (distance >= reach) return 0;
  const double level = light.brightnessAt(point);
  if (!lambert) return level;
  // The middle of a ball can lie behind a plane that a part of it lights.
  return level * std::max(0.0, dot(toLight, normal) / distance);
}

}  // namespace hearth
