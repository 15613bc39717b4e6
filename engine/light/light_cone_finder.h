#pragma once

#include "light/light_cone.h"
#include "light/raytracer.h"

namespace hearth {

/// All that a point of light sees, no farther than `reach` metres, sorted by sectors, and of these
/// by the walls where cones end; what is doubtful along a line comes before. Where they take
/// `mostBytes` or more, it stops, and they are not complete.
///
/// From the sector of the light on, a window is cut at the vertices of the walls, and the nearest
/// wall in each part ends a cone. Openings of that wall, and flat portals before it, are windows
/// into other sectors.
LightConeSet findLightCones(const Level& level, const Raytracer::Source& light, double reach,
                            std::size_t mostBytes);

}  // namespace hearth
