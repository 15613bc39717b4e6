#pragma once

#include <string>

#include "lint/lint.h"

namespace hearth {

/// The position of a surface's image on its wall.
struct Hanging {
  double along;  ///< metres, as in the file
  double z;      ///< absolute height at which it begins
  bool hasZRef;  ///< whether the file gives that
};

/// The description of the texture of a surface of a wall.
struct WallTexture {
  const TextureDescription* described;
  std::string_view key;  ///< of the wall
};

WallTexture textureOf(const LintedLevel& linted, SurfaceId surface);

Hanging hangingOf(const LintedLevel& linted, SurfaceId surface);

/// So many repeats of the image farther back along the wall, and lower; 0 leaves a height alone.
Hanging movedBack(const Hanging& hanging, Vec2 repeat, double u, double v);

/// The text for the wall: `"texture": { "name": "brick", "along": 0.5 }`.
std::string written(const WallTexture& texture, const Hanging& hanging);

}  // namespace hearth
