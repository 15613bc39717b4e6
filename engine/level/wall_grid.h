#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <span>
#include <vector>

#include "level/ids.h"
#include "level/segment.h"
#include "math/box.h"
#include "math/vec.h"

namespace hearth {

/// A grid of cells over the walls of one sector. A ray asks the walls of the cells that it crosses,
/// a body or a shaft those of the cells that it covers. A wall is in all cells that it comes nearer
/// to than `kSlack`, which is far more than rounding moves a ray or a crossing. So whoever looks
/// for the first of the walls, or for those in some place, finds what all walls would give.
class WallGrid {
 public:
  /// Expects: the box is around the walls.
  WallGrid(std::span<const Segment> walls, const Box& box, CellId firstCell);

  /// The cells are `firstCell` and those after it.
  std::size_t cellCount() const { return static_cast<std::size_t>(columns_) * rows_; }
  double metresPerCell() const { return 1 / perMetre_; }
  const Box& box() const { return box_; }
  std::size_t bytes() const {
    return sizeof *this + sizeof(std::uint32_t) * (begin_.capacity() + walls_.capacity());
  }

  /// Indices into the sector's segments, rising.
  std::span<const std::uint32_t> wallsIn(CellId cell) const {
    const std::size_t i = cell.index() - firstCell_.index();
    return {walls_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }

  /// Calls `visit(cell)` for the cells that the ray `origin + t * delta` crosses from `tBegin` on,
  /// one after the other (J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray
  /// Tracing", 1987). `visit` returns up to which t crossings matter: all walls that the ray meets
  /// from `tBegin` up to there are in the cells visited.
  template <typename Visit>
  void alongRay(Vec2 origin, Vec2 delta, double tBegin, Visit&& visit) const;

  /// Adds the walls of the cells that a convex outline covers, each once, rising.
  void addUnder(std::span<const Vec2> outline, std::pmr::vector<std::uint32_t>& walls) const;
  void addIn(const Box& box, std::pmr::vector<std::uint32_t>& walls) const;

 private:
  /// Cells.
  static constexpr double kSlack = 1.0 / 64;
  /// Fraction of t: a thousand times kNearTie, within which walls count as equally far.
  static constexpr double kBeyond = 1e-6;

  /// One coordinate of a ray, in cells.
  class Axis {
   public:
    Axis(double at, double perT, std::uint32_t cells)
        : at_(at), cells_(static_cast<double>(cells)), isMoving_(std::abs(perT) >= kLeastMove) {
      if (!isMoving_) return;
      step_ = perT > 0 ? 1 : -1;
      perT_ = perT;
      tPerCell_ = 1 / perT;
    }

    double tEnter() const {
      if (isMoving_) return tOf(step_ > 0 ? -kSlack : cells_ + kSlack);
      return -kSlack <= at_ && at_ <= cells_ + kSlack ? -kEndless : kEndless;
    }
    double tLeave() const {
      return isMoving_ ? tOf(step_ > 0 ? cells_ + kSlack : -kSlack) : kEndless;
    }

    void beginAt(double t) {
      cell_ = static_cast<std::uint32_t>(std::clamp(at_ + t * perT_, 0.0, cells_ - 1));
      findNext();
    }
    /// Whether there is another cell.
    bool goOn() {
      cell_ += step_;
      if (cell_ < 0 || cell_ >= cells_) return false;
      findNext();
      return true;
    }
    std::size_t cell() const { return static_cast<std::size_t>(cell_); }
    double tNext() const { return tNext_; }

   private:
    static constexpr double kEndless = std::numeric_limits<double>::infinity();
    static constexpr double kLeastMove = std::numeric_limits<double>::min();

    double tOf(double place) const { return (place - at_) * tPerCell_; }
    /// From the beginning, so that no rounding adds up.
    void findNext() { tNext_ = isMoving_ ? tOf(step_ > 0 ? cell_ + 1 : cell_) : kEndless; }

    double at_;  ///< at t = 0
    double perT_ = 0;
    double tPerCell_ = 0;
    double cells_;
    double step_ = 0;
    double cell_ = 0;
    double tNext_ = kEndless;  ///< where it leaves the cell
    bool isMoving_;
  };

  Vec2 inCells(Vec2 p) const { return perMetre_ * (p - box_.min); }
  void layOut(double metresPerCell);
  bool fill(std::span<const Segment> walls);
  template <typename Visit>
  void forEachRowUnder(std::span<const Vec2> outline, Visit&& visit) const;

  Box box_;
  CellId firstCell_;
  double perMetre_ = 0;
  std::uint32_t columns_ = 0;
  std::uint32_t rows_ = 0;
  std::vector<std::uint32_t> begin_;  ///< of each cell's walls, row by row, and the end of the last
  std::vector<std::uint32_t> walls_;
};

template <typename Visit>
void WallGrid::alongRay(Vec2 origin, Vec2 delta, double tBegin, Visit&& visit) const {
  const Vec2 at = inCells(origin);
  Axis x(at.x, perMetre_ * delta.x, columns_);
  Axis y(at.y, perMetre_ * delta.y, rows_);
  const double tEnter = std::max({tBegin, x.tEnter(), y.tEnter()});
  if (!(tEnter <= std::min(x.tLeave(), y.tLeave()))) return;
  x.beginAt(tEnter);
  y.beginAt(tEnter);
  while (true) {
    const double tEnd = visit(CellId(firstCell_.index() + y.cell() * columns_ + x.cell()));
    if (std::min(x.tNext(), y.tNext()) > tEnd * (1 + kBeyond)) return;
    if (!(x.tNext() < y.tNext() ? x.goOn() : y.goOn())) return;
  }
}

}  // namespace hearth
