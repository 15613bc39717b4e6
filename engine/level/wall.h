#pragma once

#include <cstddef>
#include <cstdint>
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
  std::optional<TextureMapping> maskedMiddle{};  ///< hangs in the opening, not repeated vertically
};

using SubWallKind = std::variant<Solid, Portal>;

struct SubWall {
  double z = 0;  ///< of its top, above the floor; unused in the last, which reaches the ceiling
  SubWallKind kind;
};

/// Several walls one above the other, bottom to top.
struct Stack {
  std::vector<SubWall> subWalls;

  /// The absolute height of a sub-wall's top in a sector with these flats.
  double topOf(std::size_t subWall, double zFloor, double zCeiling) const {
    return subWall + 1 == subWalls.size() ? zCeiling : zFloor + subWalls[subWall].z;
  }
};

using Wall = std::variant<Solid, Portal, Stack>;

/// The sectors that a wall leads to, each once, in order.
std::vector<SectorId> targetsOf(const Wall& wall);
/// The sector that a wall leads to, or a sub-wall of a stack; none of a solid one.
std::optional<SectorId> targetOf(const Wall& wall, std::uint32_t subWall);

}  // namespace hearth
