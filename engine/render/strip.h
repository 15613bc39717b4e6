#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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

  const std::uint32_t* row(int row) const {
    return &pixels_[static_cast<std::size_t>(row) * kColumns];
  }

  int firstColumn() const { return firstColumn_; }

 private:
  int firstColumn_ = 0;
  std::vector<std::uint32_t> pixels_;
};

/// So many neighbouring strips are drawn before they are copied to the picture together. Each row
/// of a large picture lies in a page of memory of its own, and finding a page takes longer than
/// copying eight pixels.
inline constexpr std::size_t kStripsTogether = 8;
using StripsTogether = std::array<Strip, kStripsTogether>;

/// Copies each pixel of neighbouring strips, one to kStripsTogether of them, to a square of pixels
/// of the picture, whose edge may cut the square.
void copyStrips(std::span<const Strip> strips, const PixelRows& picture, int pixelSize);

}  // namespace hearth
