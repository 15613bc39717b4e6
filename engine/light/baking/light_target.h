#pragma once

#include "level/ids.h"
#include "light/grid/plane.h"
#include "math/vec.h"

namespace hearth {

/// A point of a surface to be lit.
struct LightTarget {
  Vec3 point;       ///< where rays arrive, on the border of the air of `sector`
  SectorId sector;  ///< whose air the surface bounds
  Plane plane;      ///< the surface's, its normal into the air
};

}  // namespace hearth
