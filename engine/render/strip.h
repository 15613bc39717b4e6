#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

#include "image/pixel_rows.h"

namespace hearth {

/// Eight neighbouring columns of a picture while they are drawn, row by row. They stay in the
/// processor's caches (8 columns of 1080 rows are 34 KB).
class Strip {
 public:
  static constexpr int kColumns = 8;

  /// How many strips a picture has.
  static int countIn(int width) { return (width + kColumns - 1) / kColumns; }

  /// Begins a strip of a picture, all of whose pixels are to be painted. It keeps its memory.
  void begin(int index, int height) {
    firstColumn_ = index * kColumns;
    pixels_.resize(static_cast<std::size_t>(height) * kColumns);
  }

  /// Begins a strip with all pixels in one colour.
  void begin(int index, int height, Rgb color) {
    begin(index, height);
    std::ranges::fill(pixels_, toXrgb(color));
  }

  /// The eight pixels of a row. The next row follows. Columns beyond the picture have pixels, too.
  std::uint32_t* row(int row) { return &pixels_[static_cast<std::size_t>(row) * kColumns]; }

  /// A pixel by its place in the picture.
  std::uint32_t* at(int column, int row) { return this->row(row) + (column - firstColumn_); }

  /// Copies each pixel to a square of pixels of the picture, whose edge may cut the square.
  void copyTo(const PixelRows& picture, int pixelSize) const;

 private:
  int firstColumn_ = 0;
  std::vector<std::uint32_t> pixels_;
};

}  // namespace hearth
