// Whether a curve passes cells near one another soon.

#include "math/hilbert_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <vector>

namespace hearth {
namespace {

TEST(HilbertCurve, goesFromEachCellOfASquareToOneBesideIt) {
  for (const std::uint32_t corner : {0U, 48U, kHilbertCells - 16}) {
    std::vector<std::tuple<std::uint32_t, int, int>> cells;
    for (std::uint32_t y = corner; y < corner + 16; ++y)
      for (std::uint32_t x = 160; x < 176; ++x)
        cells.emplace_back(placeOnHilbertCurve(x, y), static_cast<int>(x), static_cast<int>(y));
    std::ranges::sort(cells);
    for (std::size_t i = 1; i < cells.size(); ++i) {
      const auto& [before, x0, y0] = cells[i - 1];
      const auto& [place, x1, y1] = cells[i];
      EXPECT_EQ(place, before + 1) << x1 << ' ' << y1;
      EXPECT_EQ(std::abs(x1 - x0) + std::abs(y1 - y0), 1) << x1 << ' ' << y1;
    }
  }
}

TEST(HilbertCurve, beginsAndEndsInTheLowerCorners) {
  EXPECT_EQ(placeOnHilbertCurve(0, 0), 0U);
  EXPECT_EQ(placeOnHilbertCurve(kHilbertCells - 1, 0), ~0U);
}

}  // namespace
}  // namespace hearth
