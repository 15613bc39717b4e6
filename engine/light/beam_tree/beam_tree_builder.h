#pragma once

#include <cstddef>
#include <optional>

#include "light/beam_tree/beam.h"
#include "light/rays/raytracer.h"
#include "math/box.h"

namespace hearth {

/// Which beams of a light are found.
struct BeamLimits {
  double reach;  ///< metres up to which all are found, and perhaps some beyond
  /// If the beams take so much or more, the search stops, and they are not complete.
  std::size_t maxBytes;
  /// Only beams to points of this part of the map, which may be empty, are asked for.
  std::optional<Box> region;
  /// Metres beside the region to which beams are found, too, so that no rounding leaves out any.
  static constexpr double kBesideRegion = 0.01;
};

/// The beams of a point light, sorted by sector, and within a sector by the wall where they end;
/// beams that are doubtful along a line come first.
///
/// From the sector of the light on, a window is cut at the vertices of the walls, and the nearest
/// wall in each part ends a beam. Openings of that wall, and flat portals before it, are windows
/// into other sectors.
BeamSet findLightBeams(const Scene& scene, const Raytracer::Source& light,
                       const BeamLimits& limits);

}  // namespace hearth
