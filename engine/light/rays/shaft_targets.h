#pragma once

#include <span>

#include "level/ids.h"
#include "light/rays/shaft_hull.h"

namespace hearth {

/// What several rays between a light and some targets meet: each of them a surface before its end,
/// none of them, or one or the other.
enum class TargetVisibility { Dark, Lit, Unknown };

/// What a light may see.
struct ShaftTargets {
  TargetBox box;
  std::span<const SectorId> sectors;  ///< whose air the targets bound
};

}  // namespace hearth
