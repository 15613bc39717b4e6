#pragma once

#include <vector>

#include "level/scene.h"
#include "light/grid/vertex_fan.h"
#include "light/texel_grid.h"

namespace hearth {

/// The texel grid of every segment, by SegmentId: anchored to the first vertex, by (x, y), of the
/// run of walls that continue one another in one plane, along the run's longest wall.
std::vector<TexelGrid> wallGrids(const Level& level, const VertexFan& fan, double texel);

TexelGrid flatGrid(double z, double texel);

/// The texel grid of every sloped floor (ceiling), by SectorId: anchored to the first border
/// vertex, by (x, y), of the run of slopes that continue one another in one plane; axes along the
/// contour line and the steepest ascent of the slope with that vertex. Entries of sectors without
/// such a slope are unused.
std::vector<TexelGrid> slopeGrids(const Scene& scene, bool floor, double texel);

/// True when the floors (ceilings) of two sectors, flats or slopes, are one plane within an
/// author's tolerance, over the given segment.
bool continueInOnePlane(const Scene& scene, const Sector& a, const Sector& b, bool floor,
                        const Segment& along);

}  // namespace hearth
