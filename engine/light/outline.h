#pragma once

#include <cstddef>
#include <vector>

#include "math/vec.h"

namespace hearth {

/// Closed polygons, holes among them: a point is inside when it is inside an odd number of them.
class Outline {
 public:
  struct Edge {
    Vec2 a;
    Vec2 b;
  };
  /// Of a row of points, from one to another.
  struct Stretch {
    double from;
    double to;
  };

  Outline() = default;
  /// At least one of them, of at least three points each.
  explicit Outline(const std::vector<std::vector<Vec2>>& polygons);

  /// Those it was made from.
  std::vector<std::vector<Vec2>> polygons() const;

  bool contains(Vec2 p) const;
  /// The point of the polygons that is nearest.
  Vec2 nearest(Vec2 p) const;
  /// No farther than `reach`.
  std::vector<Edge> edgesWithin(Vec2 p, double reach) const;

  /// With those edges alone that come as near as `reach` to the points of a row. Of such a point it
  /// says the same, except for what is farther from it than that.
  Outline aroundRow(double row, double reach) const;

  /// The parts of the row that lie inside, farther than `margin` from all edges: in rising order,
  /// and apart.
  std::vector<Stretch> insideAlong(double row, double margin) const;
  /// The parts with a point of the inside, or of an edge, no farther than `margin` along both axes:
  /// in rising order, and apart.
  std::vector<Stretch> nearAlong(double row, double margin) const;

 private:
  std::vector<Stretch> besideEdges(double row, double margin) const;
  bool isInsideBetween(double row, const Stretch& before, const Stretch& after) const;

  std::vector<Edge> edges_;
  std::vector<std::size_t> ends_;  ///< of the polygons' edges
};

}  // namespace hearth
