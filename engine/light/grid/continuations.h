#pragma once

#include <vector>

#include "level/level.h"
#include "light/grid/upright_air.h"
#include "light/grid/vertex_fan.h"
#include "light/lit_surface.h"

namespace hearth {

struct UprightSurface {
  SurfaceId id;
  UprightOutline air;
};

/// Finds which surfaces continue which in one plane over a common edge, and notes it in `surfaces`,
/// which are complete but for that: walls along and above one another, round vertices, through
/// openings and flat portals; flats and slopes through openings. `upright` is by SegmentId.
void joinContinuations(const Level& level, const VertexFan& fan,
                       const std::vector<std::vector<UprightSurface>>& upright,
                       LitSurfaces& surfaces);

}  // namespace hearth
