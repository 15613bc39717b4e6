#pragma once

#include <cstdint>

namespace hearth::textures {

/// The stone, pebble or tuft that a pixel belongs to: one lies at random in every square cell.
struct Cell {
  int id;      ///< looks random; the same for all its pixels
  int dx;      ///< pixels from its middle to the right
  int dy;      ///< and down
  int border;  ///< pixels to the line that parts it from the nearest other one, about
};

/// The nearest middle to a pixel, on a pattern that repeats with the tile. `side` in pixels divides
/// the tile's; `jitter` is how far a middle may be moved, at most `side`.
Cell nearestCell(int x, int y, int side, int jitter, std::uint32_t seed);

}  // namespace hearth::textures
