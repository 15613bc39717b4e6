#pragma once

#include <optional>

#include "level/ids.h"
#include "math/vec.h"

namespace hearth {

/// How an image lies on a surface. levels/README.md has the formulas for u and v of each kind.
struct TextureMapping {
  TextureId texture;
  Vec2 repeat = {1, 1};        ///< metres that one repeat of the image covers, along u and v; > 0
  Vec2 offsetTexels = {0, 0};  ///< shift of the image, in texels
  double along = 0;            ///< walls: metres that `s` starts at, instead of 0
  std::optional<double> zRef;  ///< walls: the absolute height at which v is 0, when authored
};

}  // namespace hearth
