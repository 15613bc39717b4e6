#pragma once

#include <cstdint>

#include "light/bakery.h"
#include "light/baking/light_visibility.h"
#include "light/baking/texel_sums.h"

namespace hearth {

/// The texel of a sprite, in place of a grid.
inline constexpr TexelRect kSpriteTexel{0, 0, 1, 1};

/// The sums of a sprite's one texel, of one sample: the light at its point of air. Adds the rays
/// that it took.
TexelSums lightOfSprite(const Scene& scene, const LightVisibilities& visibilities,
                        const Sprite& sprite, std::int64_t& rays);

/// Gives each sprite the light of its point of air, as a lightmap of one texel. No sprite casts a
/// shadow. `visibilities` are of the same scene. Counts rays where there are `surfaceCosts`.
void lightSprites(const Scene& scene, const LightVisibilities& visibilities, int threads,
                  BakedLight& baked);

}  // namespace hearth
