#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "level/ids.h"
#include "level/texture_mapping.h"

namespace hearth {

/// A wall that nothing passes.
struct Solid {
  TextureMapping texture;
};

/// A wall that opens to another sector, with steps where that sector's flats are in the way.
struct Portal {
  SectorId next;
  std::optional<TextureMapping> upper;
  std::optional<TextureMapping> lower;
  std::optional<TextureMapping> maskedMiddle{};  ///< hangs in the opening, once from top to bottom
};

using SubWallKind = std::variant<Solid, Portal>;

struct SubWall {
  double zTop = 0;  ///< absolute; the last one's is its sector's ceiling
  SubWallKind kind;
};

/// Several walls one above the other, bottom to top.
struct Stack {
  std::vector<SubWall> subWalls;
};

using Wall = std::variant<Solid, Portal, Stack>;

}  // namespace hearth
