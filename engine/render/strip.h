#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "image/image.h"
#include "image/pixel_rows.h"
#include "render/texture.h"

namespace hearth {

/// A few columns of a picture while they are drawn, stored one after the other. They are so few
/// that the processor's caches hold them together with their part of the picture (8 columns of 1080
/// rows are 36 KB).
class Strip {
 public:
  static constexpr int kColumns = 8;

  /// How many strips a picture has.
  static int countIn(int width) { return (width + kColumns - 1) / kColumns; }

  /// Begins a strip of a picture, all of whose pixels are to be painted. It keeps its memory.
  void begin(int index, int height) {
    firstColumn_ = index * kColumns;
    rowsPerColumn_ = static_cast<std::size_t>(height) + kSpareRows;
    pixels_.resize(rowsPerColumn_ * kColumns);
  }

  /// Begins a strip with all pixels in one colour.
  void begin(int index, int height, Rgb color) {
    begin(index, height);
    std::ranges::fill(pixels_, pixelOf(color));
  }

  /// A pixel by its place in the picture; the one below it follows.
  Pixel* at(int column, int row) {
    return &pixels_[static_cast<std::size_t>(column - firstColumn_) * rowsPerColumn_ +
                    static_cast<std::size_t>(row)];
  }

  /// Copies each pixel to a square of pixels of the picture, whose edge may cut the square.
  void copyTo(const PixelRows& picture, int pixelSize) const;

 private:
  /// Behind each column, so that neighbouring columns do not share a set of the cache at heights
  /// that are powers of two, and 4 rows can be read at once.
  static constexpr std::size_t kSpareRows = 16;

  void copySquaresTo(const PixelRows& picture, int size) const;
  Pixel pixelAt(int column, int row) const {
    return pixels_[static_cast<std::size_t>(column) * rowsPerColumn_ +
                   static_cast<std::size_t>(row)];
  }

  int firstColumn_ = 0;
  std::size_t rowsPerColumn_ = 0;
  std::vector<Pixel> pixels_;
};

}  // namespace hearth
