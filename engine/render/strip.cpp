#include "render/strip.h"

namespace hearth {

void Strip::copyTo(const PixelRows& picture, int pixelSize) const {
  const int left = firstColumn_ * pixelSize;
  const int width = std::min(kColumns * pixelSize, picture.width - left);
  const std::uint32_t* from = pixels_.data();
  if (pixelSize == 1 && width == kColumns) {
    for (int row = 0; row < picture.height; ++row, from += kColumns)
      std::memcpy(picture.at(left, row), from, kColumns * sizeof *from);  // no call: a known size
    return;
  }
  for (int top = 0; top < picture.height; top += pixelSize, from += kColumns) {
    std::uint32_t* const first = picture.at(left, top);
    for (int i = 0; i < width; ++i) first[i] = from[i / pixelSize];
    for (int row = top + 1; row < std::min(top + pixelSize, picture.height); ++row)
      std::copy_n(first, width, picture.at(left, row));
  }
}

}  // namespace hearth
