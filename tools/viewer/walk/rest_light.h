#pragma once

#include <vector>

#include "level/geometry.h"
#include "light/bakery.h"

namespace hearth {

/// The light of a level with all its movers at rest.
struct RestLight {
  std::vector<double> shares;  ///< by mover: 0 or 1
  Geometry geometry;
  BakedLight light;
};

}  // namespace hearth
