#include "load/grid/grid_loops.h"

#include <array>
#include <cstddef>
#include <utility>

namespace hearth {

namespace {

constexpr std::array<GridSide, 4> kSides{GridSide::North, GridSide::East, GridSide::South,
                                         GridSide::West};

constexpr GridSide turnedRight(GridSide side) {
  return static_cast<GridSide>((static_cast<unsigned>(side) + 1) % 4);
}
constexpr GridSide turnedLeft(GridSide side) {
  return static_cast<GridSide>((static_cast<unsigned>(side) + 3) % 4);
}

/// Steps from cell to cell.
class GridCells {
 public:
  explicit GridCells(const GridDescription& grid) : columns_(grid.columns), rows_(grid.rows) {}

  std::uint32_t columnOf(std::uint32_t cell) const { return cell % columns_; }
  std::uint32_t rowOf(std::uint32_t cell) const { return cell / columns_; }

  std::uint32_t beyond(std::uint32_t cell, GridSide side) const {
    if (cell == kBeyondGrid) return kBeyondGrid;
    switch (side) {
      case GridSide::North:
        return rowOf(cell) > 0 ? cell - columns_ : kBeyondGrid;
      case GridSide::East:
        return columnOf(cell) + 1 < columns_ ? cell + 1 : kBeyondGrid;
      case GridSide::South:
        return rowOf(cell) + 1 < rows_ ? cell + columns_ : kBeyondGrid;
      case GridSide::West:
        return columnOf(cell) > 0 ? cell - 1 : kBeyondGrid;
    }
    return kBeyondGrid;
  }

 private:
  std::uint32_t columns_;
  std::uint32_t rows_;
};

/// Numbers the sectors of cells, in the order of their first cells.
void findSectors(const GridDescription& grid, GridSectors& found) {
  const GridCells cells(grid);
  found.sectorOf.assign(grid.cells.size(), GridSectors::kNone);
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < grid.cells.size(); ++first) {
    const std::uint32_t entry = grid.cells[first];
    if (entry == GridDescription::kBlank || !grid.legend[entry].isAir() ||
        found.sectorOf[first] != GridSectors::kNone)
      continue;
    const auto sector = static_cast<std::uint32_t>(found.sectors.size());
    found.sectors.push_back({first, {}});
    found.sectorOf[first] = sector;
    open.push_back(first);
    while (!open.empty()) {
      const std::uint32_t cell = open.back();
      open.pop_back();
      for (const GridSide side : kSides) {
        const std::uint32_t next = cells.beyond(cell, side);
        if (next == kBeyondGrid || grid.cells[next] != entry ||
            found.sectorOf[next] != GridSectors::kNone)
          continue;
        found.sectorOf[next] = sector;
        open.push_back(next);
      }
    }
  }
}

/// Follows the edges of cells that have their sector on the right and another neighbour on the
/// left.
class LoopTracer {
 public:
  LoopTracer(const GridDescription& grid, GridSectors& found)
      : grid_(grid), cells_(grid), found_(found), isTraced_(grid.cells.size()) {}

  /// In reading order, the first edge of a border is above its first cell, and that of a hole is
  /// left of its first cell: both begin at the corner of least x and y.
  void traceAll(std::size_t maxVertices) {
    for (std::uint32_t cell = 0; cell < grid_.cells.size() && found_.vertices <= maxVertices;
         ++cell) {
      const std::uint32_t sector = found_.sectorOf[cell];
      if (sector == GridSectors::kNone) continue;
      if (found_.sectors[sector].firstCell == cell) trace({cell, GridSide::North});
      if (const Edge east{cell, GridSide::East}; isEdge(east) && !isTraced(east)) trace(east);
    }
  }

 private:
  struct Edge {
    std::uint32_t cell;
    GridSide side;

    friend bool operator==(const Edge&, const Edge&) = default;
  };
  /// What a wall must keep from cell to cell.
  struct Beyond {
    std::uint32_t entry;
    std::uint32_t sector;

    friend bool operator==(const Beyond&, const Beyond&) = default;
  };

  std::uint32_t sectorOf(std::uint32_t cell) const {
    return cell == kBeyondGrid ? GridSectors::kNone : found_.sectorOf[cell];
  }
  bool isEdge(const Edge& edge) const {
    return sectorOf(cells_.beyond(edge.cell, edge.side)) != sectorOf(edge.cell);
  }
  bool isTraced(const Edge& edge) const {
    return (isTraced_[edge.cell] >> static_cast<unsigned>(edge.side) & 1U) != 0;
  }
  Beyond beyond(const Edge& edge) const {
    const std::uint32_t cell = cells_.beyond(edge.cell, edge.side);
    if (cell == kBeyondGrid) return {GridDescription::kBlank, GridSectors::kNone};
    return {grid_.cells[cell], found_.sectorOf[cell]};
  }

  /// Where two cells of the sector meet only at a corner, the loop turns round the cell on its
  /// left: so no loop comes to a corner twice.
  Edge after(const Edge& edge) const {
    const std::uint32_t ahead = cells_.beyond(edge.cell, turnedRight(edge.side));
    const std::uint32_t aheadOnTheLeft = cells_.beyond(ahead, edge.side);
    const std::uint32_t sector = sectorOf(edge.cell);
    if (sectorOf(aheadOnTheLeft) == sector) return {aheadOnTheLeft, turnedLeft(edge.side)};
    if (sectorOf(ahead) == sector) return {ahead, edge.side};
    return {edge.cell, turnedRight(edge.side)};
  }

  GridWall wallFrom(const Edge& edge) const {
    const bool isEast = edge.side == GridSide::East || edge.side == GridSide::South;
    const bool isSouth = edge.side == GridSide::South || edge.side == GridSide::West;
    return {edge.cell, edge.side, cells_.columnOf(edge.cell) + (isEast ? 1 : 0),
            cells_.rowOf(edge.cell) + (isSouth ? 1 : 0), cells_.beyond(edge.cell, edge.side)};
  }

  /// `first` begins at a corner of its loop.
  void trace(const Edge& first) {
    GridLoop loop;
    Edge edge = first;
    Beyond before{};
    do {
      isTraced_[edge.cell] |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(edge.side));
      const Beyond now = beyond(edge);
      if (loop.empty() || loop.back().side != edge.side || now != before)
        loop.push_back(wallFrom(edge));
      before = now;
      edge = after(edge);
    } while (edge != first);
    found_.vertices += loop.size();
    found_.sectors[sectorOf(first.cell)].loops.push_back(std::move(loop));
  }

  const GridDescription& grid_;
  GridCells cells_;
  GridSectors& found_;
  std::vector<std::uint8_t> isTraced_;  ///< by cell: a bit for each side
};

}  // namespace

GridSectors findGridSectors(const GridDescription& grid, std::size_t maxVertices) {
  GridSectors found;
  findSectors(grid, found);
  LoopTracer(grid, found).traceAll(maxVertices);
  return found;
}

}  // namespace hearth
