#pragma once

#include <cmath>

namespace hearth {

/// floor(x) mod size, in 0 .. size - 1, however large x is: the texel of an image that repeats.
inline int wrapped(double x, int size) {
  const double rest = std::fmod(std::floor(x), size);  // exact, and of the sign of x
  return static_cast<int>(rest < 0 ? rest + size : rest);
}

}  // namespace hearth
