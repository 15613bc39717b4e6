#pragma once

#include <algorithm>
#include <cmath>

#include "settings/options.h"

namespace hearth {

/// How a picture gets the size of its window.
enum class Scaling {
  Smooth,   ///< as large as fits
  Integer,  ///< a whole number of times its size, so that its pixels stay squares
};

/// Where a picture lies in its window, in pixels; it keeps its aspect and lies in the middle.
struct Placement {
  int x;
  int y;
  int width;
  int height;
  bool hasSquarePixels;  ///< each pixel of the picture becomes as many of the window

  friend bool operator==(const Placement&, const Placement&) = default;
};

/// A window smaller than the picture shows it reduced, whatever the scaling.
inline Placement placed(ImageSize picture, ImageSize window, Scaling scaling) {
  const double fit = std::min(static_cast<double>(window.width) / picture.width,
                              static_cast<double>(window.height) / picture.height);
  const bool isWhole = fit >= 1 && (scaling == Scaling::Integer || fit == std::floor(fit));
  const double scale = isWhole ? std::floor(fit) : fit;
  const auto side = [scale](int pixels) {
    return std::max(1, static_cast<int>(std::lround(scale * pixels)));
  };
  const int width = side(picture.width);
  const int height = side(picture.height);
  return {(window.width - width) / 2, (window.height - height) / 2, width, height, isWhole};
}

/// The pixel of a picture that shows at `at` pixels from the window's left or top edge, along one
/// side of it: `begin` and `length` are the placement's, `pixels` the picture's. It
/// continues beyond the picture's edges.
inline int pixelAt(double at, int begin, int length, int pixels) {
  return static_cast<int>(std::floor((at - begin) * pixels / length));
}

}  // namespace hearth
