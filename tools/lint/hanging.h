#pragma once

#include <string>

#include "lint/lint.h"

namespace hearth {

/// Where the image of a surface hangs on its wall.
struct Hanging {
  double along;  ///< metres, as in the file
  double z;      ///< absolute, of where it begins
  bool hasZRef;  ///< whether the file gives that
};

/// What the file says of the texture of a surface of a wall.
struct WallTexture {
  const TextureDescription* described;
  std::string_view key;  ///< of the wall
};

WallTexture textureOf(const LintedLevel& linted, SurfaceId surface);

Hanging hangingOf(const LintedLevel& linted, SurfaceId surface);

/// So many repeats of the image farther back along the wall, and lower; 0 leaves a height alone.
Hanging movedBack(const Hanging& hanging, Vec2 repeat, double u, double v);

/// As the wall is to have it: `"texture": { "name": "brick", "along": 0.5 }`.
std::string written(const WallTexture& texture, const Hanging& hanging);

}  // namespace hearth
