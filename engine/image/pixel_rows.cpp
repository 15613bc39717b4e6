#include "image/pixel_rows.h"

#include "math/check.h"

namespace hearth {

void copy(const PixelRows& from, const PixelRows& to) {
  CHECK(from.width == to.width && from.height == to.height, from.width, from.height, to.width,
        to.height);
  for (int row = 0; row < from.height; ++row)
    std::copy_n(from.at(0, row), from.width, to.at(0, row));
}

Image imageOf(const PixelRows& rows) {
  Image image(rows.width, rows.height);
  if (rows.width == 0) return image;
  for (int row = 0; row < rows.height; ++row)
    std::transform(rows.at(0, row), rows.at(0, row) + rows.width, &image.at(0, row), fromXrgb);
  return image;
}

}  // namespace hearth
