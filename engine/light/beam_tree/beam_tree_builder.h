#pragma once

#include "light/beam_tree/beam.h"
#include "light/rays/raytracer.h"

namespace hearth {

/// The beams of a point light up to `reach` metres, sorted by sector, and within a sector by the
/// wall where they end; beams that are doubtful along a line come first. If the beams take
/// `maxBytes` or more, the search stops, and they are not complete.
///
/// From the sector of the light on, a window is cut at the vertices of the walls, and the nearest
/// wall in each part ends a beam. Openings of that wall, and flat portals before it, are windows
/// into other sectors.
BeamSet findLightBeams(const Scene& scene, const Raytracer::Source& light, double reach,
                       std::size_t maxBytes);

}  // namespace hearth
