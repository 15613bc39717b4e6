#pragma once

#include <cstdint>
#include <vector>

#include "level/scene.h"
#include "light/lit_surface.h"

namespace hearth {

/// Numbers by which parts of two versions of a level are known to be alike, as far as baked light
/// goes. They know sectors by their names, not by their ids, so that all that an edit leaves alone
/// keeps its number.
struct LightFingerprints {
  std::vector<std::uint64_t> sectors;   ///< by SectorId: all that a ray inside meets, and passes
  std::vector<std::uint64_t> surfaces;  ///< by SurfaceId: where it is lit; 0 for none
  std::vector<std::uint64_t> lights;    ///< in the level's order
};

LightFingerprints lightFingerprints(const Scene& scene, const LitSurfaces& surfaces);

}  // namespace hearth
