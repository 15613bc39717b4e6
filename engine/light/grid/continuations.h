#pragma once

#include <vector>

#include "level/scene.h"
#include "light/grid/upright_air.h"
#include "light/grid/vertex_fan.h"
#include "light/lit_surface.h"

namespace hearth {

struct UprightSurface {
  SurfaceId id;
  UprightOutline air;
};

/// Finds the surfaces that continue each other in one plane over a common edge, and fills
/// `continuations` in `surfaces`; all other members are already set. Walls continue walls beside
/// and above them, round vertices, and through openings and flat portals. Flats and slopes continue
/// through openings. `upright` is by SegmentId.
void joinContinuations(const Scene& scene, const VertexFan& fan,
                       const std::vector<std::vector<UprightSurface>>& upright,
                       LitSurfaces& surfaces);

}  // namespace hearth
