#include "render/strip.h"

#include <array>
#include <cstring>

namespace hearth {

namespace {

/// Strips that lie in the picture with all of their columns.
void copyPixels(std::span<const Strip> strips, const PixelRows& picture) {
  std::array<const std::uint32_t*, kStripsTogether> from{};
  for (std::size_t i = 0; i < strips.size(); ++i) from[i] = strips[i].row(0);
  for (int row = 0; row < picture.height; ++row) {
    std::uint32_t* to = picture.at(strips.front().firstColumn(), row);
    for (std::size_t i = 0; i < strips.size(); ++i, to += Strip::kColumns) {
      std::memcpy(to, from[i], Strip::kColumns * sizeof *to);  // no call: a known size
      from[i] += Strip::kColumns;
    }
  }
}

void copySquares(std::span<const Strip> strips, const PixelRows& picture, int pixelSize) {
  const int left = strips.front().firstColumn() * pixelSize;
  const int squares = static_cast<int>(strips.size()) * Strip::kColumns;
  const int width = std::min(squares * pixelSize, picture.width - left);
  for (int top = 0; top < picture.height; top += pixelSize) {
    std::uint32_t* const first = picture.at(left, top);
    std::uint32_t* to = first;
    int rest = width;
    for (const Strip& strip : strips)
      for (std::size_t i = 0; i < Strip::kColumns; ++i) {
        const int side = std::min(pixelSize, rest);
        to = std::fill_n(to, side, strip.row(top / pixelSize)[i]);
        rest -= side;
      }
    for (int row = top + 1; row < std::min(top + pixelSize, picture.height); ++row)
      std::copy_n(first, width, picture.at(left, row));
  }
}

}  // namespace

void copyStrips(std::span<const Strip> strips, const PixelRows& picture, int pixelSize) {
  if (pixelSize > 1) return copySquares(strips, picture, pixelSize);
  const bool isCut = strips.back().firstColumn() + Strip::kColumns > picture.width;
  const std::span<const Strip> whole = strips.first(strips.size() - (isCut ? 1 : 0));
  if (!whole.empty()) copyPixels(whole, picture);
  if (isCut) copySquares(strips.last(1), picture, 1);
}

}  // namespace hearth
