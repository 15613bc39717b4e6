#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
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

    /// Whether a point is no farther away than `reach`.
    bool isWithin(double reach, Vec2 p) const;
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
  /// Of few edges no memory is taken but that of `memory`.
  using EdgesNear = std::pmr::vector<Edge>;
  /// The edges no farther than `reach`.
  EdgesNear edgesWithin(Vec2 p, double reach, std::pmr::memory_resource& memory) const;

  /// Makes `around` have only the edges within `reach` of the points of a row. For such a point it
  /// gives the same answers within that distance.
  void findAroundRow(double row, double reach, Polygons& around) const;

  /// A part of a row with an edge no farther than a margin along both axes.
  struct Beside {
    Stretch part;
    bool leadsInside;  ///< what comes after it lies inside
  };
  /// Those of a row, from left to right with gaps between them.
  void findBeside(double row, double margin, std::vector<Beside>& beside) const;
  /// In each of some rows, which are 1 apart, the parts with a point of the inside, or of an edge,
  /// no farther than `margin` along both axes, in the same order.
  ListPerRow<Stretch> nearAlongRows(double firstRow, int rows, double margin) const;

 private:
  static std::optional<Beside> besideEdge(const Edge& edge, double row, double margin);
  static std::span<Beside> joined(std::span<Beside> beside);
  ListPerRow<Beside> besideEdgesInRows(double firstRow, int rows, double margin) const;

  template <typename Visit>
  void forEachEdgeIn(const Box& box, Visit&& visit) const;

  std::vector<Edge> edges_;
  std::shared_ptr<const BoxTree> tree_;    ///< of the edges, where they are many
  std::vector<std::size_t> endsOfOthers_;  ///< of the edges of all polygons but the last
};

}  // namespace hearth
