#pragma once

#include <cstdint>
#include <utility>

namespace hearth {

/// Cells a side of a grid.
inline constexpr std::uint32_t kHilbertCells = 1U << 16;

/// Where a curve through all cells of the grid passes one. It leaves no quarter before it has
/// passed all of it, nor a quarter of that, so cells that follow one another soon are near one
/// another, and mostly the other way round (D. Hilbert, "Ueber die stetige Abbildung einer Linie
/// auf ein Flaechenstueck", 1891).
constexpr std::uint32_t placeOnHilbertCurve(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0;
  for (std::uint32_t side = kHilbertCells / 2; side > 0; side /= 2) {
    const bool isRight = (x & side) != 0;
    const bool isUpper = (y & side) != 0;
    place = 4 * place + ((isRight ? 3U : 0U) ^ (isUpper ? 1U : 0U));
    // The curve through a lower quarter is turned.
    if (!isUpper) {
      if (isRight) x = ~x, y = ~y;
      std::swap(x, y);
    }
  }
  return place;
}

}  // namespace hearth
