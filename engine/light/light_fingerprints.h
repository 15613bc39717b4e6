#pragma once

#include <cstdint>
#include <vector>

#include "level/scene.h"
#include "light/lit_surface.h"

namespace hearth {

/// Hashes of parts of a level: equal hashes in two versions mean equal parts, as far as baked light
/// is concerned. They use the names of sectors, not their ids, so all parts that an edit leaves
/// alone keep their hash.
struct LightFingerprints {
  std::vector<std::uint64_t> sectors;   ///< by SectorId: all that a ray inside it can meet
  std::vector<std::uint64_t> surfaces;  ///< by SurfaceId: where it is lit; 0 for none
  std::vector<std::uint64_t> meshes;    ///< in the level's order: faces and names of sectors
  std::vector<std::uint64_t> lights;    ///< in the level's order
};

LightFingerprints lightFingerprints(const Scene& scene, const LitSurfaces& surfaces);

}  // namespace hearth
