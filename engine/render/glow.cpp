#include "render/glow.h"

#include <algorithm>
#include <cstddef>

namespace hearth {

Glow::Glow(const Level& level) {
  if (std::ranges::none_of(level.lights, &LightSource::isEmitter)) return;
  ofTextures_.resize(level.textures.size());
  for (const LightSource& light : level.lights)
    for (std::size_t i = 0; i < ofTextures_.size(); ++i)
      if (light.isEmitter() && level.textures[i] == light.texture)
        ofTextures_[i] = light.intensity / 255 *
                         Vec3{light.colorFactor(0), light.colorFactor(1), light.colorFactor(2)};
}

}  // namespace hearth
