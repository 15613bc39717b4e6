#pragma once

#include <cstddef>
#include <optional>

#include "level/level.h"

namespace hearth {

struct Geometry;

/// Each body counts once in every sector that it reaches into.
inline constexpr std::size_t kMaxBodies = 1'000'000;

/// Sets `Level::bodies`: each solid sprite's body is in its sector, in each sector to which an
/// opening leads that it crosses, and so on. If that makes more than kMaxBodies, returns the sprite
/// (an index) with which it does; the level must not be used then.
std::optional<std::size_t> addBodies(Level& level, const Geometry& geometry);

}  // namespace hearth
