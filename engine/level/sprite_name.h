#pragma once

#include <string>

#include "level/level.h"

namespace hearth {

/// What to call a sprite: its name, else that of its first image.
inline const std::string& nameOf(const Level& level, const Sprite& sprite) {
  if (!sprite.name.empty()) return sprite.name;
  return level.textures[sprite.frames.front().front().texture.index()];
}

}  // namespace hearth
