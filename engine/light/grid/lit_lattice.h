#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace hearth {

/// The lit part of a unit cell, as a polygon. Without points all is dark.
struct LitPart {
  std::array<Vec2, 8> points;
  std::size_t count = 0;

  void add(Vec2 point) { points[count++] = point; }

  /// The integral of f(Vec2) over the part; exact for polynomials of degree 2. Calls f only for
  /// points inside, because f may differ beyond the border, and always in the same order.
  template <typename Function>
  double integral(Function&& f) const {
    double sum = 0;
    for (std::size_t i = 2; i < count; ++i) {
      const Vec2 a = points[0];
      const Vec2 b = points[i - 1];
      const Vec2 c = points[i];
      const Vec2 middle = (1.0 / 6) * (a + b + c);
      const double towardsA = f(middle + 0.5 * a);
      const double towardsB = f(middle + 0.5 * b);
      const double towardsC = f(middle + 0.5 * c);
      sum += cross(b - a, c - a) / 6 * (towardsA + towardsB + towardsC);
    }
    return sum;
  }
};

inline constexpr LitPart kWholeCell{{Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}, 4};

/// Finds where light arrives on a lattice of unit cells: tests their corners, and bisects the edges
/// along which the answer changes. So a shadow's edge through a cell is as exact as it is straight.
/// A shadow that passes between corners without touching one is missed.
///
/// `IsLit` is bool(Vec2), for points of [0, columns] x [0, rows].
template <typename IsLit>
class LitLattice {
 public:
  LitLattice(int columns, int rows, IsLit isLit)
      : LitLattice(columns, rows, isLit, [&](int i, int j) { return isLit(corner(i, j)); }) {}

  /// With a quicker test for corners, bool(int i, int j).
  template <typename IsCornerLit>
  LitLattice(int columns, int rows, IsLit isLit, IsCornerLit isCornerLit)
      : columns_(columns), rows_(rows), isLit_(std::move(isLit)) {
    corners_.reserve(cornerCount());
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) corners_.push_back(isCornerLit(i, j) ? 1 : 0);
    litCorners_ = static_cast<std::size_t>(std::ranges::count(corners_, 1));
    if (isUniform()) return;
    across_ = crossings({1, 0});
    down_ = crossings({0, 1});
  }

  /// Of the cell whose first corner is (i, j); in its own coordinates, 0..1.
  LitPart part(int i, int j) const {
    if (isUniform()) return isLitAt(0, 0) ? kWholeCell : LitPart{};
    LitPart part;
    addSide(part, isLitAt(i, j), isLitAt(i + 1, j), {across_[index(i, j)], 0}, {0, 0});
    addSide(part, isLitAt(i + 1, j), isLitAt(i + 1, j + 1), {1, down_[index(i + 1, j)]}, {1, 0});
    addSide(part, isLitAt(i + 1, j + 1), isLitAt(i, j + 1), {across_[index(i, j + 1)], 1}, {1, 1});
    addSide(part, isLitAt(i, j + 1), isLitAt(i, j), {0, down_[index(i, j)]}, {0, 1});
    return part;
  }

  bool isLitAt(int i, int j) const { return corners_[index(i, j)] != 0; }
  int litCorners(int i, int j) const {
    return corners_[index(i, j)] + corners_[index(i + 1, j)] + corners_[index(i, j + 1)] +
           corners_[index(i + 1, j + 1)];
  }
  /// Whether all corners have the same answer.
  bool isUniform() const { return litCorners_ == 0 || litCorners_ == corners_.size(); }

  /// The number of calls of `isLit`.
  std::int64_t questions() const { return questions_ + static_cast<std::int64_t>(cornerCount()); }

 private:
  /// Halvings of an edge: a crossing is known to 1/64 of it, 1/128 to either side.
  static constexpr int kHalvings = 6;

  static Vec2 corner(int i, int j) { return {static_cast<double>(i), static_cast<double>(j)}; }
  static void addSide(LitPart& part, bool isLit, bool isNextLit, Vec2 crossing, Vec2 corner) {
    if (isLit) part.add(corner);
    if (isLit != isNextLit) part.add(crossing);
  }

  std::size_t cornerCount() const {
    return static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1);
  }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_ + 1) +
           static_cast<std::size_t>(i);
  }

  /// Where the answer changes on the way from each corner to its neighbour, as a fraction of the
  /// way.
  std::vector<float> crossings(Vec2 direction) {
    std::vector<float> found(cornerCount(), 0);
    const int di = static_cast<int>(direction.x);
    const int dj = static_cast<int>(direction.y);
    for (int j = 0; j + dj <= rows_; ++j)
      for (int i = 0; i + di <= columns_; ++i)
        if (isLitAt(i, j) != isLitAt(i + di, j + dj))
          found[index(i, j)] = crossing(corner(i, j), direction, isLitAt(i, j));
    return found;
  }

  float crossing(Vec2 from, Vec2 direction, bool isLitThere) {
    double low = 0;
    double high = 1;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (low + high) / 2;
      ((isLit_(from + middle * direction) == isLitThere) ? low : high) = middle;
    }
    questions_ += kHalvings;
    return static_cast<float>((low + high) / 2);
  }

  int columns_;
  int rows_;
  IsLit isLit_;
  std::vector<std::uint8_t> corners_;
  std::size_t litCorners_ = 0;
  std::vector<float> across_;
  std::vector<float> down_;
  std::int64_t questions_ = 0;
};

}  // namespace hearth
