#pragma once

#include <algorithm>
#include <cstdint>

namespace hearth {

/// The greatest whole number not above x, for |x| < 2^62; nearer to 0 than x beyond that.
/// std::floor is a call into the C library on processors of before 2008, for which all of this is
/// built.
inline std::int64_t wholeBelow(double x) {
  constexpr double kMost = 4.6e18;
  const auto cut = static_cast<std::int64_t>(std::clamp(x, -kMost, kMost));
  return static_cast<double>(cut) > x ? cut - 1 : cut;
}

}  // namespace hearth
