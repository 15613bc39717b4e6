#pragma once

#include <vector>

#include "light/bakery.h"
#include "load/load.h"

namespace hearth {

/// A level with all its movers at rest, and its light.
struct RestLight {
  std::vector<double> shares;  ///< by mover: 0 or 1
  LoadedLevel level;
  BakedLight light;
};

}  // namespace hearth
