#include "random_levels/texture_uses.h"

#include <fmt/format.h>

#include "random_levels/random_level.h"

namespace hearth::random_levels {
namespace {

double randomScale(Random& random) {
  return random.pick({1.0, 2.0, 0.5, 0.75, 3.0, 1.3, 0.37, 4.0});
}

double randomOffset(Random& random) {
  return random.pick({0.0, 3.0, -5.0, 0.5, -2.25, 17.0, 250.125, -0.1});
}

}  // namespace

TextureUse flatTexture(Random& random) {
  TextureUse use;
  if (random.chance(0.15)) {
    use.name = fmt::format("#{:06x}", random.below(0x1000000));
    return use;
  }
  use.name = random.pickFrom(kRandomLevelTextures).name;
  use.isObject = random.chance(0.3);
  if (random.chance(0.6)) use.scale = {randomScale(random), randomScale(random)};
  // The short form says the offset only after the scale.
  if ((use.scale || use.isObject) && random.chance(0.4)) {
    use.offset = {randomOffset(random), randomOffset(random)};
  }
  return use;
}

TextureUse wallTexture(Random& random) {
  TextureUse use = flatTexture(random);
  if (use.isObject && random.chance(0.4)) use.along = random.pick({0.0, 0.5, 1.7, -2.25, 12.0});
  if (use.isObject && random.chance(0.4)) use.zref = random.pick({0.0, 1.0, 2.6, -3.5, 0.1});
  return use;
}

}  // namespace hearth::random_levels
