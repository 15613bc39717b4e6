#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "light/lit_surface.h"

namespace hearth {

/// Values that change gradually over the texels of a surface. They are found at the nodes of a
/// lattice, at corners of texels, and interpolated between these. A cell that its corners do not
/// describe well enough is divided; the smallest cells have a node in their middle, too, and if
/// that is not enough, values are found at the point itself. Nodes are the same whichever points
/// are asked for, so that parts of a surface get what the whole does.
class LightLattice {
 public:
  /// Which cells are divided: as needed, down to cells of one texel or of two by two. Two do if one
  /// point will be asked for in each texel: its own value takes no more than nodes around it.
  enum class Parts { None, DownToTwo, DownToOne };
  /// How many nodes there are.
  struct Cells {
    int side;    ///< texels, about, of those that nothing divides
    int narrow;  ///< a rectangle that has no more texels across has one line of nodes in its middle
    Parts parts;
  };
  /// Finds the values at a point, in texel coordinates, of a place that may be moved; false if
  /// there is none.
  using ValuesAt = std::function<bool(Vec2, std::span<double>)>;

  /// `tolerances`, one for each value: how far interpolation may be off; of great values by a part
  /// of themselves.
  LightLattice(const TexelRect& texels, const Cells& cells, std::vector<double> tolerances,
               ValuesAt valuesAt);

  /// One of the values at a point, in texel coordinates; of one outside of the texels at the
  /// nearest.
  double at(Vec2 p, std::size_t value);

 private:
  using Node = std::uint32_t;  ///< index: its values begin at so many times the count of values
  /// Texel corners, both included.
  struct Cell {
    std::array<int, 2> from;
    std::array<int, 2> to;
    std::uint32_t firstPart = 0;  ///< of four in `cells_`; 0: not divided
    bool isDecided = false;
    bool isUneven = false;          ///< with more between its nodes than they describe
    std::array<Node, 4> corners{};  ///< of a decided one that is not divided
    std::optional<Node> middle{};   ///< of a texel whose corners differ
  };

  Node addNode(Vec2 p);
  Node nodeAt(int i, int j);
  bool isThere(Node node) const { return isThere_[node]; }
  std::span<const double> valuesOf(Node node) const;
  void decide(std::uint32_t cell);
  void decideTexel(Cell& cell);
  void divide(std::uint32_t cell, bool areDecided);
  std::array<Node, 4> cornersOf(const Cell& cell);
  double toleranceAt(double value, std::size_t index) const;
  bool describes(const std::array<Node, 4>& corners, Vec2 fraction, Node node,
                 double tolerances = 1) const;
  bool areEven(const std::array<Node, 4>& corners) const;
  double interpolated(const Cell& cell, Vec2 p, std::size_t value) const;
  double interpolated(const std::array<Node, 4>& corners, Vec2 fraction, std::size_t value) const;
  double found(Vec2 p, std::size_t value);

  TexelRect texels_;
  std::vector<double> tolerances_;
  Parts parts_;
  ValuesAt valuesAt_;
  std::vector<int> columns_;  ///< where cells that nothing divides begin, and the end
  std::vector<int> rows_;
  std::vector<Cell> cells_;  ///< first those of columns and rows
  std::unordered_map<std::uint64_t, Node> nodes_;
  std::vector<double> values_;
  std::vector<bool> isThere_;
  Vec2 foundAt_{};             ///< the last point itself ...
  std::vector<double> found_;  ///< ... and its values; none before the first
};

}  // namespace hearth
