#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "load/read/description.h"

/// Which cells of a grid make up sectors, and the loops around them.
namespace hearth {

/// A straight part of a loop, from one vertex to the next. Seen from its sector it runs from left
/// to right: along the northern side of a cell eastwards, along the eastern side southwards, ...
struct GridWall {
  std::uint32_t cell;       ///< of the sector: the first one along the wall
  GridSide side;            ///< of that cell
  std::uint32_t column;     ///< of its first vertex, between the cells ...
  std::uint32_t row;        ///< ... and likewise
  std::uint32_t neighbour;  ///< the cell beyond the first one, or kBeyondGrid
};
inline constexpr std::uint32_t kBeyondGrid = ~std::uint32_t{0};

using GridLoop = std::vector<GridWall>;

struct GridSector {
  std::uint32_t firstCell;      ///< in reading order
  std::vector<GridLoop> loops;  ///< the border first
};

struct GridSectors {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::vector<std::uint32_t> sectorOf;  ///< by cell; kNone where there is no air
  std::vector<GridSector> sectors;      ///< in the order of their first cells
  std::size_t vertices = 0;             ///< of all loops
};

/// Air cells of one entry that touch along an edge are one sector. If there are more than
/// `maxVertices`, it stops as soon as it finds them.
GridSectors findGridSectors(const GridDescription& grid, std::size_t maxVertices);

}  // namespace hearth
