#include "level/shining_textures.h"

#include <set>

namespace hearth {

std::vector<std::string_view> texturesThatCanShine(const Level& level) {
  std::set<std::string_view> names;
  const auto add = [&](TextureId id) { names.insert(level.textures[id.index()]); };
  for (const Surface& surface : level.surfaces)
    if (canShine(surface.kind)) add(surface.mapping.texture);
  for (const MeshFace& face : level.meshFaces) add(face.texture);
  for (const SwitchTexture& texture : level.switchTextures) add(texture.on);
  return {names.begin(), names.end()};
}

}  // namespace hearth
