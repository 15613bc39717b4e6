#include "import/doom/picture.h"

#include <utility>

namespace hearth::doom {

Image withHoles(Picture picture) {
  if (!picture.hasHoles()) return std::move(picture.image);
  std::size_t i = 0;
  for (int y = 0; y < picture.image.height(); ++y)
    for (int x = 0; x < picture.image.width(); ++x)
      if (!picture.isOpaque[i++]) picture.image.makeHole(x, y);
  return std::move(picture.image);
}

Image mirrored(const Image& image) {
  Image result(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const int from = image.width() - 1 - x;
      result.at(x, y) = image.at(from, y);
      if (image.isHole(from, y)) result.makeHole(x, y);
    }
  return result;
}

}  // namespace hearth::doom
