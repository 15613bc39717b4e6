#pragma once

#include "light/bakery.h"
#include "light/baking/light_visibility.h"

namespace hearth {

/// The texel of a sprite, in place of a grid.
inline constexpr TexelRect kSpriteTexel{0, 0, 1, 1};

/// Gives each sprite the light of its point of air, as a lightmap of one texel. No sprite casts a
/// shadow. `visibilities` are of the same scene. Counts rays where there are `surfaceCosts`.
void lightSprites(const Scene& scene, const LightVisibilities& visibilities, int threads,
                  BakedLight& baked);

}  // namespace hearth
