#pragma once

#include "light/beam_tree/beam.h"
#include "light/sight/raytracer.h"

namespace hearth {

/// All that a point of light sees, no farther than `reach` metres, sorted by sectors, and of these
/// by the walls where beams end; what is doubtful along a line comes before. Where they take
/// `mostBytes` or more, it stops, and they are not complete.
///
/// From the sector of the light on, a window is cut at the vertices of the walls, and the nearest
/// wall in each part ends a beam. Openings of that wall, and flat portals before it, are windows
/// into other sectors.
BeamSet findLightBeams(const Scene& scene, const Raytracer::Source& light, double reach,
                       std::size_t mostBytes);

}  // namespace hearth
