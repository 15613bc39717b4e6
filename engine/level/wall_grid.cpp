#include "level/wall_grid.h"

#include <array>
#include <utility>

#include "math/check.h"

namespace hearth {

namespace {

/// On average over the cells of a grid, those of a wall. Where walls are so long that they cross
/// more, cells are larger.
constexpr std::size_t kMostCellsPerWall = 8;

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Adds the part of a line from a to b that is between two heights of y.
void addBetween(double yLow, double yHigh, Vec2 a, Vec2 b, Extent& x) {
  if (a.y > b.y) std::swap(a, b);
  if (b.y < yLow || a.y > yHigh) return;
  const auto xAt = [&](double y) { return std::lerp(a.x, b.x, (y - a.y) / (b.y - a.y)); };
  x.add(a.y < yLow ? xAt(yLow) : a.x);
  x.add(b.y > yHigh ? xAt(yHigh) : b.x);
}

/// The cell of a coordinate, or the nearest.
std::uint32_t cellAt(double place, std::uint32_t cells) {
  return static_cast<std::uint32_t>(std::clamp(place, 0.0, cells - 1.0));
}

}  // namespace

WallGrid::WallGrid(std::span<const Segment> walls, const Box& box, CellId firstCell)
    : box_(box), firstCell_(firstCell) {
  const Vec2 size = box.max - box.min;
  const auto count = static_cast<double>(walls.size());
  // As many cells as walls, of a box that is not too narrow.
  double metres = std::max(std::sqrt(size.x * size.y / count), box.longerSide() / count);
  CHECK(metres > 0, walls.size(), size.x, size.y);
  for (layOut(metres); !fill(walls); layOut(metres)) metres *= 2;
}

void WallGrid::layOut(double metresPerCell) {
  const Vec2 size = box_.max - box_.min;
  perMetre_ = 1 / metresPerCell;
  columns_ = static_cast<std::uint32_t>(std::max(1.0, std::ceil(size.x * perMetre_)));
  rows_ = static_cast<std::uint32_t>(std::max(1.0, std::ceil(size.y * perMetre_)));
}

/// Whether the walls are in no more cells than they may be.
bool WallGrid::fill(std::span<const Segment> walls) {
  const auto forEachCellOf = [&](const Segment& wall, auto&& visit) {
    const std::array ends{wall.p0, wall.p1};
    forEachRowUnder(ends, [&](std::size_t first, std::size_t last) {
      for (std::size_t cell = first; cell <= last; ++cell) visit(cell);
    });
  };
  begin_.assign(cellCount() + 1, 0);
  std::size_t filled = 0;
  for (const Segment& wall : walls) {
    forEachCellOf(wall, [&](std::size_t cell) { ++begin_[cell + 1], ++filled; });
    if (filled > kMostCellsPerWall * walls.size()) return false;
  }
  for (std::size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
  walls_.resize(filled);
  std::vector<std::uint32_t> end(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < walls.size(); ++i)
    forEachCellOf(walls[i],
                  [&](std::size_t cell) { walls_[end[cell]++] = static_cast<std::uint32_t>(i); });
  return true;
}

/// Calls `visit(first, last)` for the cells of each row that a convex outline covers.
template <typename Visit>
void WallGrid::forEachRowUnder(std::span<const Vec2> outline, Visit&& visit) const {
  Extent rows;
  for (const Vec2 p : outline) rows.add(inCells(p).y);
  if (!(rows.low - kSlack <= rows_ && rows.high + kSlack >= 0)) return;
  const std::size_t lastRow = cellAt(rows.high + kSlack, rows_);
  for (std::size_t row = cellAt(rows.low - kSlack, rows_); row <= lastRow; ++row) {
    const auto y = static_cast<double>(row);
    Extent x;
    for (std::size_t i = 0, before = outline.size() - 1; i < outline.size(); before = i++)
      addBetween(y - kSlack, y + 1 + kSlack, inCells(outline[before]), inCells(outline[i]), x);
    if (x.low - kSlack <= columns_ && x.high + kSlack >= 0)
      visit(row * columns_ + cellAt(x.low - kSlack, columns_),
            row * columns_ + cellAt(x.high + kSlack, columns_));
  }
}

void WallGrid::addUnder(std::span<const Vec2> outline,
                        std::pmr::vector<std::uint32_t>& walls) const {
  const auto old = static_cast<std::ptrdiff_t>(walls.size());
  forEachRowUnder(outline, [&](std::size_t first, std::size_t last) {
    walls.insert(walls.end(), walls_.begin() + begin_[first], walls_.begin() + begin_[last + 1]);
  });
  std::sort(walls.begin() + old, walls.end());
  walls.erase(std::unique(walls.begin() + old, walls.end()), walls.end());
}

void WallGrid::addIn(const Box& box, std::pmr::vector<std::uint32_t>& walls) const {
  // What is outside holds no walls, and may be endless.
  const Box inside = intersection(box, grown(box_, metresPerCell()));
  if (inside.min.x > inside.max.x || inside.min.y > inside.max.y) return;
  addUnder(std::array{inside.min, Vec2{inside.max.x, inside.min.y}, inside.max,
                      Vec2{inside.min.x, inside.max.y}},
           walls);
}

}  // namespace hearth
