#include "light/baking/sprite_light.h"

#include <vector>

#include "light/baking/unshadowed_brightness.h"
#include "math/parallel.h"

namespace hearth {

TexelSums lightOfSprite(const Scene& scene, const LightVisibilities& visibilities,
                        const Sprite& sprite, std::int64_t& rays) {
  const Vec3 point = lightPointOf(scene, sprite);
  constexpr int kChannels = 3;
  TexelSums sums(kSpriteTexel, kChannels);
  AreaVisibility areas = visibilities.areas();
  std::vector<double> ofAreas(areas.lights().size());
  if (!ofAreas.empty()) areas.findFromAir(point, sprite.sector, ofAreas, rays);
  const auto seenFraction = [&](std::size_t i) {
    if (scene.lights()[i].isArea()) return ofAreas[areas.placeOf(i)];
    if (const SunVisibility* const sun = visibilities.sun(i))
      return sun->seenFractionFromAir(point, sprite.sector, rays);
    return visibilities.fine(i).seenFractionFromAir(point, sprite.sector, rays);
  };
  for (const std::size_t i : visibilities.reach.reaching({point, point})) {
    const LightSource& light = scene.lights()[i];
    constexpr bool kLambert = false;  // the air has no normal
    const double brightness =
        unshadowedBrightness(light, visibilities.reach.metres(i), point, {}, kLambert);
    if (brightness <= 0) continue;
    sums.add(0, 0, light, brightness * seenFraction(i));
  }
  return sums;
}

void lightSprites(const Scene& scene, const LightVisibilities& visibilities, int threads,
                  BakedLight& baked) {
  const std::vector<Sprite>& sprites = scene.level().sprites;
  parallelFor(sprites.size(), threads, [&](std::size_t i) {
    const std::size_t surface = sprites[i].surface.index();
    std::int64_t rays = 0;
    baked.lightmaps[surface] = lightOfSprite(scene, visibilities, sprites[i], rays).toLightmap(1);
    if (!baked.surfaceCosts.empty()) baked.surfaceCosts[surface].rays = rays;
  });
}

}  // namespace hearth
