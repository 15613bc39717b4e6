#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "light/list_per_row.h"
#include "math/box.h"
#include "math/box_tree.h"
#include "math/vec.h"

namespace hearth {

/// Closed polygons, some of them holes: a point is inside if an odd number of them contain it.
class Polygons {
 public:
  struct Edge {
    Vec2 a;
    Vec2 b;
  };
  /// A part of a row of points.
  struct Stretch {
    double from;
    double to;
  };

  Polygons() = default;
  /// At least one of them, of at least three points each.
  explicit Polygons(std::span<const std::vector<Vec2>> polygons);

  /// The polygons that it was made from.
  std::vector<std::vector<Vec2>> loops() const;

  bool contains(Vec2 p) const;
  /// The nearest point of the polygons.
  Vec2 nearest(Vec2 p) const;
  /// False only if no point of the inside lies in the box.
  bool mayMeet(const Box& box) const;
  /// About the area of all that is inside, or no farther than `margin` from an edge. Holes run the
  /// other way round than what they are in.
  double areaNear(double margin) const;
  /// The edges no farther than `reach`.
  std::vector<Edge> edgesWithin(Vec2 p, double reach) const;

  /// Only the edges within `reach` of the points of a row. For such a point it gives the same
  /// answers within that distance.
  Polygons aroundRow(double row, double reach) const;

  /// The parts of the row that lie inside, farther than `margin` from all edges, from left to
  /// right with gaps between them.
  std::vector<Stretch> insideAlong(double row, double margin) const;
  /// In each of some rows, which are 1 apart, the parts with a point of the inside, or of an edge,
  /// no farther than `margin` along both axes, in the same order.
  ListPerRow<Stretch> nearAlongRows(double firstRow, int rows, double margin) const;

 private:
  /// A part of a row with an edge no farther than a margin along both axes.
  struct Beside {
    Stretch part;
    bool leadsInside;  ///< what comes after it lies inside
  };
  static std::optional<Beside> besideEdge(const Edge& edge, double row, double margin);
  static std::span<Beside> joined(std::span<Beside> beside);
  std::vector<Beside> besideEdges(double row, double margin) const;
  ListPerRow<Beside> besideEdgesInRows(double firstRow, int rows, double margin) const;

  template <typename Visit>
  void forEachEdgeIn(const Box& box, Visit&& visit) const;

  std::vector<Edge> edges_;
  std::shared_ptr<const BoxTree> tree_;    ///< of the edges, where they are many
  std::vector<std::size_t> endsOfOthers_;  ///< of the edges of all polygons but the last
};

}  // namespace hearth
