#include "light/grid/slope_reach.h"

#include <algorithm>

#include "math/tolerance.h"

namespace hearth {

bool hasSlopeAt(const Level& level, const Sector& sector, double z) {
  const auto comesThere = [&](const std::optional<Slope>& slope, const Flat& flat) {
    if (!slope) return false;
    double low = flat.z;
    double high = flat.z;
    for (const Segment& wall : level.segmentsOf(sector)) {
      low = std::min(low, slope->zAt(wall.p0));
      high = std::max(high, slope->zAt(wall.p0));
    }
    return low < z + kPositionSlack && high > z - kPositionSlack;
  };
  return comesThere(sector.floorSlope, sector.floor) ||
         comesThere(sector.ceilingSlope, sector.ceiling);
}

}  // namespace hearth
