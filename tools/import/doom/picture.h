#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/image_file.h"

namespace hearth::doom {

/// Pixels of the longest side that is taken: four times the widest of Freedoom's.
inline constexpr int kMaxSide = 4096;

struct Picture {
  /// `background` is what its pixels are until something is drawn over them.
  Picture(ImageSize size, Rgb background)
      : image(size.width, size.height, background), isOpaque(image.pixels().size(), false) {}

  Image image;
  /// By pixel, row by row. The others are holes, through which one sees what is behind a wall.
  std::vector<bool> isOpaque;
  /// What could not be drawn, and why: one sentence each.
  std::vector<std::string> mistakes;

  bool hasHoles() const {
    return !std::ranges::all_of(isOpaque, [](bool is) { return is; });
  }

  void draw(int x, int y, Rgb color) {
    image.at(x, y) = color;
    isOpaque[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width()) +
             static_cast<std::size_t>(x)] = true;
  }
};

/// Its image, with holes where nothing is drawn.
Image withHoles(Picture picture);
/// Left and right exchanged.
Image mirrored(const Image& image);

}  // namespace hearth::doom
