#pragma once

#include <optional>
#include <vector>

#include "level/sector.h"
#include "math/vec.h"
#include "render/camera.h"

namespace hearth {

/// Of the rays through the middles of rows [0, rows).
inline void findRaySlopes(const Projection& projection, int rows, std::vector<double>& raySlopes) {
  raySlopes.clear();
  for (int row = 0; row < rows; ++row) raySlopes.push_back(projection.raySlopeAt(row + 0.5));
}

/// How far a floor or ceiling rises along a ray on the map, per metre of depth.
inline double riseAlong(const std::optional<Slope>& slope, Vec2 ray) {
  return slope ? dot(slope->gradient, ray) : 0;
}

}  // namespace hearth
