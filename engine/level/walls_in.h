#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "level/level.h"

namespace hearth {

/// Calls `visit(segment)` for all walls of a sector that come into a box, and for some others, in
/// the sector's order.
template <typename Visit>
void forEachWallIn(const Level& level, const Sector& sector, const Box& box, Visit&& visit) {
  const std::span<const Segment> all = level.segmentsOf(sector);
  const WallGrid* const grid = level.wallGridOf(sector);
  if (!grid) {
    for (const Segment& wall : all) visit(wall);
    return;
  }
  std::array<std::byte, 4096> memory;
  std::pmr::monotonic_buffer_resource arena(memory.data(), memory.size());
  std::pmr::vector<std::uint32_t> walls(&arena);
  walls.reserve(memory.size() / sizeof(std::uint32_t));
  grid->addIn(box, walls);
  for (const std::uint32_t i : walls) visit(all[i]);
}

/// Around a point, all that is no farther from it.
constexpr Box boxAround(Vec2 p, double reach) { return grown({p, p}, reach); }

}  // namespace hearth
