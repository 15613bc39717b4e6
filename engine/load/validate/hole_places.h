#pragma once

#include <cstdint>
#include <functional>

#include "load/link/outline.h"

namespace hearth {

/// Finds the holes of a sector that plainly lie inside its border and outside its other holes, and
/// calls `check(hole)` for the rest, which says whether the hole does so. Holes are indices of its
/// loops.
///
/// Expects: no two loops cross; `touches(hole)` tells whether a hole touches another loop.
void checkHolePlaces(const Outlines& outlines, const OutlineSector& sector, const BoxTree& tree,
                     const std::function<bool(std::uint32_t)>& touches,
                     const std::function<bool(std::uint32_t)>& check);

}  // namespace hearth
