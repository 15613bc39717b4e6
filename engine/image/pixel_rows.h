#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace hearth {

/// A view of a picture being drawn, rows top to bottom, in memory that the caller owns, such as a
/// window's. A pixel has 32 bits: blue in the lowest, then green and red. The highest mean nothing.
struct PixelRows {
  std::uint32_t* first;
  std::size_t stride;  ///< pixels from the beginning of a row to that of the next
  int width;
  int height;

  std::uint32_t* at(int column, int row) const {
    return first + static_cast<std::size_t>(row) * stride + column;
  }

  /// A rectangle of the picture, which lies in it.
  PixelRows part(int left, int top, int partWidth, int partHeight) const {
    return {at(left, top), stride, partWidth, partHeight};
  }

  void fill(Rgb color) const;
};

/// The pixel of a colour.
constexpr std::uint32_t toXrgb(Rgb color) {
  return std::uint32_t{color.r} << 16 | std::uint32_t{color.g} << 8 | color.b;
}

constexpr Rgb fromXrgb(std::uint32_t pixel) {
  return {static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
          static_cast<std::uint8_t>(pixel)};
}

inline void PixelRows::fill(Rgb color) const {
  for (int row = 0; row < height; ++row) std::fill_n(at(0, row), width, toXrgb(color));
}

/// Memory for one picture after the other.
class PixelBuffer {
 public:
  /// Rows of this size, whose pixels may be of any colour; valid until the next call. Takes memory
  /// only to grow.
  PixelRows rows(int width, int height) {
    const std::size_t perRow = static_cast<std::size_t>(width);
    const std::size_t size = perRow * static_cast<std::size_t>(height);
    if (pixels_.size() < size) pixels_.resize(size);
    return {pixels_.data(), perRow, width, height};
  }

 private:
  std::vector<std::uint32_t> pixels_;
};

/// Copies a picture to rows of the same size.
void copy(const PixelRows& from, const PixelRows& to);

/// A copy as an Image.
Image imageOf(const PixelRows& rows);

}  // namespace hearth
