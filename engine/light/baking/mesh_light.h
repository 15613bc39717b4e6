#pragma once

#include <cstdint>
#include <span>

#include "light/bakery.h"
#include "light/baking/light_visibility.h"

namespace hearth {

/// Gives some meshes, by index, the light of all their faces: what is larger than a texel as
/// surfaces get it, smaller faces at their corners. `baked.meshes` has them, on grids of
/// `settings`; `visibilities` are of the same scene. Adds to
/// the costs of `baked` where it has some.
void lightMeshes(const Scene& scene, const LightVisibilities& visibilities,
                 const BakeSettings& settings, int threads, std::span<const std::uint32_t> meshes,
                 BakedLight& baked);

}  // namespace hearth
