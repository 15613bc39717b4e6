#include "render/strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hearth {
namespace {

/// A number for each square of a picture.
std::uint32_t numberOf(int column, int row) {
  return static_cast<std::uint32_t>(1000 * row + column + 1);
}

/// Strips from one of a picture on, whose pixels are numbered.
void number(std::span<Strip> strips, int first, int rows) {
  for (Strip& strip : strips) {
    strip.begin(first++, rows);
    for (int row = 0; row < rows; ++row)
      for (int i = 0; i < Strip::kColumns; ++i)
        strip.row(row)[i] = numberOf(strip.firstColumn() + i, row);
  }
}

TEST(CopiedStrips, fillPicturesOfAnySizeAndNothingElse) {
  for (const int pixelSize : {1, 2, 3})
    for (const int width : {1, 7, 8, 9, 16, 61, 64, 65, 130}) {
      const int height = 10;
      PixelBuffer memory;
      const PixelRows all = memory.rows(width + 1, height);
      const PixelRows picture = all.part(0, 0, width, height);
      all.fill({});
      const int rows = (height + pixelSize - 1) / pixelSize;
      const int strips = Strip::countIn((width + pixelSize - 1) / pixelSize);
      StripsTogether together;
      for (int first = 0; first < strips; first += static_cast<int>(kStripsTogether)) {
        const auto count = static_cast<std::size_t>(strips - first);
        const std::span next = std::span(together).first(std::min(kStripsTogether, count));
        number(next, first, rows);
        copyStrips(next, picture, pixelSize);
      }
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column)
          ASSERT_EQ(*picture.at(column, row), numberOf(column / pixelSize, row / pixelSize))
              << width << " columns, " << pixelSize << " a side: " << column << ", " << row;
        ASSERT_EQ(*all.at(width, row), 0U) << "beyond " << width << " columns";
      }
    }
}

}  // namespace
}  // namespace hearth
