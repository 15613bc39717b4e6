#include "light/gather/area_lights.h"

namespace hearth {

AreaLights::AreaLights(const Scene& scene) : ofTextures_(scene.level().textures.size()) {
  const Level& level = scene.level();
  for (std::size_t i = 0; i < scene.lights().size(); ++i) {
    const LightSource& light = scene.lights()[i];
    if (!light.isArea()) continue;
    const auto place = static_cast<Place>(lights_.size());
    lights_.push_back(i);
    if (light.isSky) sky_ = place;
    if (light.isBounced && !bounced_) bounced_ = place;
    if (!light.isEmitter()) continue;
    haveEmitters_ = true;
    for (std::size_t texture = 0; texture < level.textures.size(); ++texture)
      if (level.textures[texture] == light.texture) ofTextures_[texture] = place;
  }
  haveShiningFaces_ =
      haveEmitters_ && std::ranges::any_of(level.meshFaces, [this](const MeshFace& face) {
        return ofTexture(face.texture).has_value();
      });
}

}  // namespace hearth
