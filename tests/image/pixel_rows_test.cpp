#include "image/pixel_rows.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/padded_rows.h"

namespace hearth {
namespace {

using test::kUntouched;
using test::PaddedRows;

constexpr Rgb kColor = {10, 200, 30};

/// All of them different, with something in the highest bits.
void number(const PixelRows& rows) {
  for (int y = 0; y < rows.height; ++y)
    for (int x = 0; x < rows.width; ++x)
      *rows.at(x, y) =
          0xFF000000 | toXrgb({static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 7});
}

TEST(Pixels, HaveBlueLowestThenGreenAndRed) {
  EXPECT_EQ(toXrgb({0x12, 0x34, 0x56}), 0x123456U);
  EXPECT_EQ(fromXrgb(0x123456), (Rgb{0x12, 0x34, 0x56}));
}

TEST(Pixels, MeanNothingByTheirHighestBits) {
  EXPECT_EQ(fromXrgb(0xFF123456), (Rgb{0x12, 0x34, 0x56}));
  EXPECT_EQ(fromXrgb(toXrgb({255, 255, 255})), (Rgb{255, 255, 255}));
  EXPECT_EQ(toXrgb({255, 255, 255}) >> 24, 0U);
}

TEST(PixelRows, HaveTheSamePixelsInAPart) {
  const PaddedRows memory(5, 4);
  const PixelRows part = memory.rows.part(1, 2, 3, 2);
  EXPECT_EQ(part.width, 3);
  EXPECT_EQ(part.height, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) EXPECT_EQ(part.at(x, y), memory.rows.at(1 + x, 2 + y));
  EXPECT_EQ(part.part(1, 1, 2, 1).at(0, 0), memory.rows.at(2, 3)) << "a part of a part";
}

TEST(PixelRows, AreFilledAndNothingBesideThem) {
  const PaddedRows memory(4, 3);
  memory.rows.part(1, 1, 2, 2).fill(kColor);
  for (std::size_t i = 0; i < memory.pixels.size(); ++i) {
    const std::size_t x = i % memory.rows.stride;
    const std::size_t y = i / memory.rows.stride;
    const bool isInside = (y == 1 || y == 2) && (x == 1 || x == 2);
    EXPECT_EQ(memory.pixels[i], isInside ? toXrgb(kColor) : kUntouched) << i;
  }
}

TEST(PixelRows, AreCopiedToOthersOfAnyLengthAndNothingBesideThem) {
  const PaddedRows from(3, 2);
  number(from.rows);
  const PaddedRows to(7, 4);
  copy(from.rows, to.rows.part(2, 1, 3, 2));
  EXPECT_EQ(imageOf(to.rows.part(2, 1, 3, 2)), imageOf(from.rows));
  to.rows.part(2, 1, 3, 2).fill({});
  for (const std::uint32_t pixel : to.pixels) EXPECT_TRUE(pixel == kUntouched || pixel == 0);
}

TEST(PixelRows, AreNotCopiedToOthersOfAnotherSize) {
  const PaddedRows from(3, 2);
  EXPECT_DEATH(copy(from.rows, PaddedRows(2, 2).rows), "width");
  EXPECT_DEATH(copy(from.rows, PaddedRows(3, 1).rows), "height");
}

TEST(PixelRows, AreAnImageOfTheirColours) {
  const PaddedRows memory(5, 4);
  number(memory.rows);
  const Image image = imageOf(memory.rows.part(1, 2, 3, 2));
  ASSERT_EQ(image.width(), 3);
  ASSERT_EQ(image.height(), 2);
  EXPECT_FALSE(image.hasHoles());
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) {
      const Rgb color{static_cast<std::uint8_t>(1 + x), static_cast<std::uint8_t>(2 + y), 7};
      EXPECT_EQ(image.at(x, y), color);
    }
}

TEST(PixelRows, MayBeNone) {
  PixelBuffer none;
  for (const auto& [width, height] : {std::pair(0, 0), {0, 3}, {3, 0}}) {
    const PixelRows rows = none.rows(width, height);
    rows.fill(kColor);
    copy(rows, rows);
    EXPECT_EQ(imageOf(rows), Image(width, height));
  }
}

TEST(PixelBuffer, HasRowsOfTheSizeThatIsAskedFor) {
  PixelBuffer buffer;
  for (const auto& [width, height] : {std::pair(4, 3), {40, 30}, {3, 4}, {1, 1}}) {
    const PixelRows rows = buffer.rows(width, height);
    EXPECT_EQ(rows.width, width);
    EXPECT_EQ(rows.height, height);
    rows.fill(kColor);
    EXPECT_EQ(imageOf(rows), Image(width, height, kColor));
  }
}

TEST(PixelBuffer, TakesMemoryOnlyToGrow) {
  PixelBuffer buffer;
  EXPECT_EQ(buffer.rows(0, 0).first, nullptr) << "none yet";
  const std::uint32_t* const first = buffer.rows(40, 30).first;
  for (const auto& [width, height] :
       {std::pair(30, 40), {1, 1}, {0, 0}, {0, 7}, {1200, 1}, {40, 30}})
    EXPECT_EQ(buffer.rows(width, height).first, first) << width << 'x' << height;
}

}  // namespace
}  // namespace hearth
