#include "light/grid/slope_reach.h"

#include <algorithm>

#include "math/tolerance.h"

namespace hearth {

bool hasSlopeAt(const Scene& scene, const Sector& sector, double z) {
  const auto comesThere = [&](const std::optional<Slope>& slope, double zFlat) {
    if (!slope) return false;
    double low = zFlat;
    double high = zFlat;
    for (const Segment& wall : scene.segmentsOf(sector)) {
      low = std::min(low, slope->zAt(wall.p0));
      high = std::max(high, slope->zAt(wall.p0));
    }
    return low < z + kPositionSlack && high > z - kPositionSlack;
  };
  return comesThere(sector.floorSlope, scene.zFloor(sector)) ||
         comesThere(sector.ceilingSlope, scene.zCeiling(sector));
}

}  // namespace hearth
