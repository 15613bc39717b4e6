#pragma once

#include <string>
#include <string_view>

#include "lint/lint.h"

namespace hearth {

/// Where the texture of a surface lies on its wall.
struct TexturePlacement {
  double along;  ///< metres, as in the file
  double z;      ///< absolute height at which it begins
  bool hasZRef;  ///< whether the file gives that
};

/// The description of the texture of a surface of a wall.
struct WallTexture {
  const TextureDescription* description;
  std::string_view key;  ///< of the wall
};

/// Whether an entry of a grid's legend describes it, and other walls with it.
bool isOfGrid(const LintedLevel& linted, SurfaceId surface);

/// Of all kinds of surface except masked middles. In a grid, the texture of the legend.
WallTexture textureOf(const LintedLevel& linted, SurfaceId surface);

TexturePlacement placementOf(const LintedLevel& linted, SurfaceId surface);

/// The placement moved back along the wall by `u` repeats, and down by `v` repeats. If `v` is 0,
/// the height stays as it is.
TexturePlacement shiftedBack(const TexturePlacement& placement, Vec2 repeat, double u, double v);

/// The text for the wall: `"texture": { "name": "brick", "along": 0.5 }`.
std::string placementText(const WallTexture& texture, const TexturePlacement& placement);

}  // namespace hearth
