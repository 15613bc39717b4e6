#pragma once

#include <cmath>
#include <numbers>

namespace hearth::test {

/// Of a rectangle, parallel to a plane and so far above it, over one of its corners (Lambert).
inline double factorOverCorner(double a, double b, double height) {
  const double x = a / height;
  const double y = b / height;
  const double ofX = x / std::sqrt(1 + x * x);
  const double ofY = y / std::sqrt(1 + y * y);
  return (ofX * std::atan(y / std::sqrt(1 + x * x)) + ofY * std::atan(x / std::sqrt(1 + y * y))) /
         (2 * std::numbers::pi);
}

}  // namespace hearth::test
