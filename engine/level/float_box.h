#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "math/box3.h"

namespace hearth {

/// A number in single precision that is less than `x`, by up to four roundings.
inline float floatBelow(double x) {
  using Float = std::numeric_limits<float>;
  constexpr double kLargest = Float::max();
  if (x < -kLargest) return -Float::infinity();
  if (x > kLargest) return Float::max();
  return static_cast<float>(x - std::abs(x) * Float::epsilon() - Float::min());
}

inline float floatAbove(double x) { return -floatBelow(-x); }

/// A box in single precision: half as large as a Box3, and with two additions of four numbers to
/// grow. Empty until something is added.
struct FloatBox {
  /// Along x, y and z. The last one is not used: compilers make vectors of four.
  using Corner = std::array<float, 4>;
  static constexpr float kEndless = std::numeric_limits<float>::infinity();

  Corner min{kEndless, kEndless, kEndless, kEndless};
  Corner max{-kEndless, -kEndless, -kEndless, -kEndless};

  /// Rounded outwards.
  static FloatBox around(const Box3& box) {
    return {{floatBelow(box.min.x), floatBelow(box.min.y), floatBelow(box.min.z), 0},
            {floatAbove(box.max.x), floatAbove(box.max.y), floatAbove(box.max.z), 0}};
  }

  void add(const FloatBox& other) {
    for (std::size_t i = 0; i < min.size(); ++i) {
      min[i] = std::min(min[i], other.min[i]);
      max[i] = std::max(max[i], other.max[i]);
    }
  }

  /// Of its sides; 0 of an empty one.
  float halfArea() const {
    if (min[0] > max[0]) return 0;
    const float x = max[0] - min[0];
    const float y = max[1] - min[1];
    const float z = max[2] - min[2];
    return x * y + y * z + z * x;
  }

  friend bool operator==(const FloatBox&, const FloatBox&) = default;
};

}  // namespace hearth
