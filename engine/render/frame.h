#pragma once

#include <cstddef>
#include <vector>

#include "image/image.h"

namespace hearth {

/// A picture while it is drawn: column by column, as spans write it.
class Frame {
 public:
  void clear(int width, int height, Rgb color) {
    width_ = width;
    height_ = height;
    pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), color);
  }

  Rgb* column(int x) {
    return &pixels_[static_cast<std::size_t>(x) * static_cast<std::size_t>(height_)];
  }

  /// Row by row, in blocks that fit the cache. An image of the right size keeps its memory.
  void copyTo(Image& image) const {
    constexpr int kBlock = 32;
    if (image.width() != width_ || image.height() != height_) image = Image(width_, height_);
    for (int x0 = 0; x0 < width_; x0 += kBlock)
      for (int y = 0; y < height_; ++y)
        for (int x = x0; x < x0 + kBlock && x < width_; ++x)
          image.at(x, y) = pixels_[static_cast<std::size_t>(x) * static_cast<std::size_t>(height_) +
                                   static_cast<std::size_t>(y)];
  }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<Rgb> pixels_;
};

}  // namespace hearth
