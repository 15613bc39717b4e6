#pragma once

#include <algorithm>
#include <limits>

#include "math/vec.h"

namespace hearth {

/// A box along the axes, borders included. Empty until a point is added.
struct Box3 {
  static constexpr double kEndless = std::numeric_limits<double>::infinity();

  Vec3 min{kEndless, kEndless, kEndless};
  Vec3 max{-kEndless, -kEndless, -kEndless};

  constexpr void add(Vec3 p) { add(Box3{p, p}); }
  constexpr void add(const Box3& other) {
    min = {std::min(min.x, other.min.x), std::min(min.y, other.min.y),
           std::min(min.z, other.min.z)};
    max = {std::max(max.x, other.max.x), std::max(max.y, other.max.y),
           std::max(max.z, other.max.z)};
  }

  /// It, and all that is so far from it along an axis.
  constexpr Box3 grownBy(double margin) const {
    const Vec3 most{margin, margin, margin};
    return {min - most, max + most};
  }
  constexpr bool meets(const Box3& other) const {
    return min.x <= other.max.x && other.min.x <= max.x && min.y <= other.max.y &&
           other.min.y <= max.y && min.z <= other.max.z && other.min.z <= max.z;
  }

  /// From a point to the nearest one of it.
  constexpr Vec3 vectorFrom(Vec3 p) const {
    return Vec3{std::clamp(p.x, min.x, max.x), std::clamp(p.y, min.y, max.y),
                std::clamp(p.z, min.z, max.z)} -
           p;
  }

  /// The farthest point of it along a direction.
  constexpr Vec3 farthest(Vec3 along) const {
    return {along.x < 0 ? min.x : max.x, along.y < 0 ? min.y : max.y, along.z < 0 ? min.z : max.z};
  }

  friend constexpr bool operator==(const Box3&, const Box3&) = default;
};

}  // namespace hearth
