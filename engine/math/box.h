#pragma once

#include <algorithm>
#include <limits>

#include "math/vec.h"

namespace hearth {

/// An axis-parallel rectangle, borders included; may be endless. Empty until a point is added.
struct Box {
  Vec2 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  constexpr void add(Vec2 p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  constexpr bool isEmpty() const { return min.x > max.x; }
  constexpr double longerSide() const { return std::max(max.x - min.x, max.y - min.y); }
  constexpr bool contains(Vec2 p) const {
    return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y;
  }

  friend constexpr bool operator==(Box, Box) = default;
};

constexpr Box boxOf(Vec2 a, Vec2 b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// Whether they have a point in common.
constexpr bool touch(Box a, Box b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}
/// Whether they have more than borders in common.
constexpr bool overlap(Box a, Box b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

/// The smallest box around both.
constexpr Box join(Box a, Box b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}
constexpr Box intersection(Box a, Box b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}
constexpr Box grown(Box box, double margin) {
  return {box.min - Vec2{margin, margin}, box.max + Vec2{margin, margin}};
}

}  // namespace hearth
