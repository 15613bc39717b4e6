#include "truth/truth_emission.h"

#include <cstddef>

namespace hearth {

TruthEmission::TruthEmission(const Level& level) : levels_(level.textures.size()) {
  for (const LightSource& light : level.lights)
    for (std::size_t i = 0; i < levels_.size(); ++i)
      if (light.isEmitter() && level.textures[i] == light.texture)
        levels_[i] = light.intensity *
                     Vec3{light.colorFactor(0), light.colorFactor(1), light.colorFactor(2)};
}

Vec3 TruthEmission::of(const TruthHit& hit) const {
  if (isSky(hit.kind) || hit.sprite || hit.kind == SurfaceKind::MaskedMiddle) return {};
  return levels_[hit.texture->texture.index()];
}

}  // namespace hearth
