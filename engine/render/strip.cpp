// Compiled once for each instruction set, see row_kernels.cpp.

#include "render/strip.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/strip.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR

int copyBlocks(const Pixel*, std::size_t, const PixelRows&, int) { return 0; }

#else

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::Full128<Pixel> kFour;
constexpr hn::Repartition<std::uint64_t, decltype(kFour)> kTwo;
constexpr hn::Repartition<std::uint8_t, decltype(kFour)> kBytes;
using FourPixels = hn::Vec<decltype(kFour)>;
using Bytes = hn::Vec<decltype(kBytes)>;

/// Four rows of four pixels.
struct Block {
  FourPixels rows[4];
};

/// Of four columns, each so many pixels behind the one before it.
HWY_INLINE Block transposed(const Pixel* column, std::size_t next) {
  const auto a = hn::LoadU(kFour, column);
  const auto b = hn::LoadU(kFour, column + next);
  const auto c = hn::LoadU(kFour, column + 2 * next);
  const auto d = hn::LoadU(kFour, column + 3 * next);
  const auto abUpper = hn::BitCast(kTwo, hn::InterleaveLower(kFour, a, b));
  const auto cdUpper = hn::BitCast(kTwo, hn::InterleaveLower(kFour, c, d));
  const auto abLower = hn::BitCast(kTwo, hn::InterleaveUpper(kFour, a, b));
  const auto cdLower = hn::BitCast(kTwo, hn::InterleaveUpper(kFour, c, d));
  return {{hn::BitCast(kFour, hn::InterleaveLower(kTwo, abUpper, cdUpper)),
           hn::BitCast(kFour, hn::InterleaveUpper(kTwo, abUpper, cdUpper)),
           hn::BitCast(kFour, hn::InterleaveLower(kTwo, abLower, cdLower)),
           hn::BitCast(kFour, hn::InterleaveUpper(kTwo, abLower, cdLower))}};
}

/// Bytes of four pixels by their numbers.
HWY_INLINE FourPixels picked(FourPixels pixels, Bytes numbers) {
  return hn::BitCast(kFour, hn::TableLookupBytes(hn::BitCast(kBytes, pixels), numbers));
}

/// Writes a row of eight pixels with red and blue changed about.
HWY_INLINE void writeRow(FourPixels left, FourPixels right, Pixel* to) {
  alignas(16) constexpr std::uint8_t kTurned[] = {2,  1, 0, 3,  6,  5,  4,  7,
                                                  10, 9, 8, 11, 14, 13, 12, 15};
  const Bytes turned = hn::Load(kBytes, kTurned);
  hn::StoreU(picked(left, turned), kFour, to);
  hn::StoreU(picked(right, turned), kFour, to + 4);
}

/// Copies eight columns to a picture, and says how many rows: multiples of four.
int copyBlocks(const Pixel* pixels, std::size_t rowsPerColumn, const PixelRows& picture,
               int firstColumn) {
  const int rows = picture.height / 4 * 4;
  Pixel* to = picture.at(firstColumn, 0);
  for (int row = 0; row < rows; row += 4) {
    const Block left = transposed(pixels + row, rowsPerColumn);
    const Block right = transposed(pixels + 4 * rowsPerColumn + row, rowsPerColumn);
    for (int i = 0; i < 4; ++i, to += picture.pixelsPerRow)
      writeRow(left.rows[i], right.rows[i], to);
  }
  return rows;
}

#endif

}  // namespace
}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hearth {

namespace {

HWY_EXPORT(copyBlocks);

std::uint32_t turned(Pixel pixel) { return packed(colorOf(pixel)); }

}  // namespace

void Strip::copyTo(const PixelRows& picture, int pixelSize) const {
  if (pixelSize > 1) return copySquaresTo(picture, pixelSize);
  const int columns = std::min(kColumns, picture.width - firstColumn_);
  const int copied =
      columns == kColumns
          ? HWY_DYNAMIC_DISPATCH(copyBlocks)(pixels_.data(), rowsPerColumn_, picture, firstColumn_)
          : 0;
  for (int row = copied; row < picture.height; ++row)
    for (int i = 0; i < columns; ++i) *picture.at(firstColumn_ + i, row) = turned(pixelAt(i, row));
}

void Strip::copySquaresTo(const PixelRows& picture, int size) const {
  const int left = firstColumn_ * size;
  const int width = std::min(kColumns * size, picture.width - left);
  for (int top = 0; top < picture.height; top += size) {
    std::uint32_t* const first = picture.at(left, top);
    for (int i = 0; i < width; ++i) first[i] = turned(pixelAt(i / size, top / size));
    for (int row = top + 1; row < std::min(top + size, picture.height); ++row)
      std::copy_n(first, width, picture.at(left, row));
  }
}

}  // namespace hearth
#endif
