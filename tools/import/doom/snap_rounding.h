#pragma once

#include <compare>
#include <optional>
#include <vector>

namespace hearth::doom {

/// A point of a square grid. Coordinates of up to 2^18 either way are computed with exactly.
struct GridPoint {
  int x;
  int y;

  friend auto operator<=>(GridPoint, GridPoint) = default;
};

/// Where two segments cross that have no end on each other, rounded to the grid.
std::optional<GridPoint> crossingOf(GridPoint a, GridPoint b, GridPoint c, GridPoint d);

/// Iterated snap rounding (Halperin and Packer, "Iterated snap rounding", 2002): segments become
/// paths over points of a grid that do not cross, and no point lies nearer than half a cell to a
/// piece of a path that does not end in it. Each given point is *hot*: a segment that passes the
/// square of one cell round it is led through it, and what that makes of it again, until nothing
/// passes a hot square. The given points hold the ends and the crossings of all segments.
class SnapRounding {
 public:
  explicit SnapRounding(std::vector<GridPoint> hot);

  /// From one hot point to another: both, and those between in their order.
  std::vector<GridPoint> pathOf(GridPoint from, GridPoint to) const;

 private:
  /// In their order.
  std::vector<GridPoint> passedOnTheWay(GridPoint from, GridPoint to) const;

  std::vector<GridPoint> hot_;  ///< sorted
};

}  // namespace hearth::doom
