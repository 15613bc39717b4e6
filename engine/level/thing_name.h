#pragma once

#include <string>

#include "level/level.h"

namespace hearth {

/// What to call a sprite: its name, else that of its first image.
inline const std::string& nameOf(const Level& level, const Sprite& sprite) {
  if (!sprite.name.empty()) return sprite.name;
  return level.textures[sprite.frames.front().front().texture.index()];
}

/// What to call a mesh: its name, else its number.
inline std::string nameOf(const Level& level, const Mesh& mesh) {
  if (!mesh.name.empty()) return mesh.name;
  return std::to_string(&mesh - level.meshes.data());
}

}  // namespace hearth
