#pragma once

#include <vector>

#include "level/scene.h"

namespace hearth {

/// A part of a segment that opens at the very bottom (top) of its sector's air.
struct OpenStretch {
  SectorId next;
  double begin;  ///< fraction of the way from p0 to p1
  double end;
};

/// The parts of a segment where nothing stands between the floors (ceilings) of its sector and the
/// next: neither a step nor a slope.
std::vector<OpenStretch> openAtFoot(const Scene& scene, const Segment& segment, bool floor);

}  // namespace hearth
