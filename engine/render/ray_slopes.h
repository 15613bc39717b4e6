#pragma once

#include <vector>

#include "render/camera.h"

namespace hearth {

/// Of the rays through the middles of rows [0, rows).
inline void findRaySlopes(const Projection& projection, int rows, std::vector<double>& raySlopes) {
  raySlopes.clear();
  for (int row = 0; row < rows; ++row) raySlopes.push_back(projection.raySlopeAt(row + 0.5));
}

}  // namespace hearth
