#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "light/lit_surface.h"

namespace hearth {

/// Values that change gradually over the texels of a surface. They are found at the nodes of a
/// lattice, in middles of texels, and interpolated between these. A cell that its corners do not
/// describe well enough is divided, down to the texels. Nodes are the same whichever points are
/// asked for, so that parts of a surface get what the whole does.
class LightLattice {
 public:
  /// How many nodes there are.
  struct Cells {
    int side;  ///< texels, about, of those that nothing divides
    /// A rectangle that has no more texels across has one line of nodes: in its middle or, of two
    /// texels, in the first.
    int narrow;
    bool areDivided;  ///< where needed
  };
  /// Finds the values at the middle of a texel, or where its sample is moved to; false if there are
  /// none.
  using ValuesAt = std::function<bool(int i, int j, std::span<double>)>;

  /// `tolerances`, one for each value: how far interpolation may be off; of great values by a part
  /// of themselves.
  LightLattice(const TexelRect& texels, const Cells& cells, std::vector<double> tolerances,
               ValuesAt valuesAt);

  /// One of the values at a point, in texel coordinates; of one beyond the middles of the outermost
  /// texels at the nearest.
  double at(Vec2 p, std::size_t value);

 private:
  using Node = std::uint32_t;  ///< index: its values begin at so many times the count of values
  /// Texels, both included.
  struct Cell {
    std::array<int, 2> from;
    std::array<int, 2> to;
    std::uint32_t firstPart = 0;  ///< of four in `cells_`; 0: not divided
    bool isDecided = false;
    std::array<Node, 4> corners{};  ///< of a decided one that is not divided
  };

  Node nodeAt(int i, int j);
  bool isThere(Node node) const { return isThere_[node]; }
  std::span<const double> valuesOf(Node node) const;
  void decide(std::uint32_t cell);
  void divide(std::uint32_t cell, bool areDecided);
  std::array<Node, 4> cornersOf(const Cell& cell);
  double toleranceAt(double value, std::size_t index) const;
  bool describes(const std::array<Node, 4>& corners, Vec2 fraction, Node node) const;
  double interpolated(const std::array<Node, 4>& corners, Vec2 fraction, std::size_t value) const;

  TexelRect texels_;
  std::vector<double> tolerances_;
  bool areDivided_;
  ValuesAt valuesAt_;
  std::vector<int> columns_;  ///< where cells that nothing divides begin, and the end
  std::vector<int> rows_;
  std::vector<Cell> cells_;  ///< first those of columns and rows
  std::unordered_map<std::uint64_t, Node> nodes_;
  std::vector<double> values_;
  std::vector<bool> isThere_;
};

}  // namespace hearth
