#pragma once

#include <cstddef>
#include <optional>

#include "level/level.h"

namespace hearth {

struct Geometry;

/// Each mesh counts once in every sector that it is in.
inline constexpr std::size_t kMaxMeshesInSectors = 1'000'000;

/// Sets `Level::meshesBySector`: each mesh is in its own sector, in each sector to which an opening
/// leads from there that one of its faces crosses or touches, and so on. If that makes more than
/// kMaxMeshesInSectors, returns the mesh (an index) with which it does; the level must not be used
/// then.
std::optional<std::size_t> addMeshSectors(Level& level, const Geometry& geometry);

}  // namespace hearth
