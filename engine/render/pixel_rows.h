#pragma once

#include <cstddef>
#include <cstdint>

namespace hearth {

/// The rows of a picture, top to bottom, in memory of others, such as a window's. A pixel has 32
/// bits: blue in the lowest, then green and red. The highest mean nothing.
struct PixelRows {
  std::uint32_t* first;
  std::size_t pixelsPerRow;  ///< from the beginning of a row to that of the next
  int width;
  int height;

  std::uint32_t* at(int column, int row) const {
    return first + static_cast<std::size_t>(row) * pixelsPerRow + column;
  }
};

}  // namespace hearth
