#pragma once

#include "image/pixel_rows.h"

namespace hearth::test {

/// A picture that a test draws into and looks at.
class Canvas {
 public:
  Canvas(int width, int height, Rgb fill = {}) : rows_(memory_.rows(width, height)) {
    rows_.fill(fill);
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  operator const PixelRows&() { return rows_; }

  int width() const { return rows_.width; }
  int height() const { return rows_.height; }
  Rgb at(int x, int y) const { return fromXrgb(*rows_.at(x, y)); }
  Image image() const { return imageOf(rows_); }

 private:
  PixelBuffer memory_;
  PixelRows rows_;
};

}  // namespace hearth::test
