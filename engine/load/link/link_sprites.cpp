#include "load/link/link.h"
#include "load/link/position_finder.h"

namespace hearth {

namespace {

std::vector<std::vector<SpriteView>> linkedFrames(TextureTable& textures,
                                                  const SpriteDescription& described) {
  std::vector<std::vector<SpriteView>> frames;
  for (const std::vector<NameReference>& views : described.frames) {
    std::vector<SpriteView>& frame = frames.emplace_back();
    for (const NameReference& image : views)
      frame.push_back({textures.idOf(image), described.size.value_or(Vec2{})});
  }
  return frames;
}

}  // namespace

void linkSprites(Linking& linking) {
  if (linking.description.sprites.empty()) return;
  const PositionFinder finder(linking);
  for (const SpriteDescription& described : linking.description.sprites) {
    std::vector<std::vector<SpriteView>> frames = linkedFrames(linking.textures, described);
    const auto standing = finder.find(described);
    if (!standing) continue;
    Sprite& sprite = linking.level.sprites.emplace_back(described.sprite);
    sprite.position = standing->position;
    sprite.sector = standing->sector;
    sprite.standsOnFloor = !described.z;
    sprite.frames = std::move(frames);
  }
}

}  // namespace hearth
