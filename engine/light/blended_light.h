#pragma once

#include <span>

#include "level/scene.h"
#include "light/bakery.h"

namespace hearth {

/// The light of a level with all its movers at rest, and how much it counts.
struct LightAtRest {
  Scene scene;
  const BakedLight* light;  ///< baked with the texels of the blend
  double weight;
};

/// The light of a level while some movers are between their ends: of each texel the weighted sum of
/// its light in `states`, rounded half up. `shown` and the scenes of `states` differ only in the
/// heights of flats, and in what stands on these. A texel of a step moves with the flat whose edge
/// the step is: the next sector's floor below an opening, its ceiling above one. All other texels
/// of walls stay in place. Where a texel lies beyond the surface in a state, it takes the nearest
/// light of the surface there; a surface that does not show in a state is dark in it.
BakedLight blendedLight(const Scene& shown, double texel, std::span<const LightAtRest> states,
                        int threads);

}  // namespace hearth
