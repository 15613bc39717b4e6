#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "level/ids.h"
#include "math/vec.h"
#include "render/strip.h"

namespace hearth {

/// What a pixel shows.
struct ShownPixel {
  std::optional<SurfaceId> surface = {};  ///< the last that was drawn there, if any
  int times = 0;                          ///< how often something was
  double depth = 0;                       ///< metres; infinite for sky
  std::optional<Vec2> texel = {};         ///< on the surface's texel grid, if it has one
};

/// What the pixels of a strip show, and those of the column before it. Strips come from left to
/// right.
class ShownStrip {
 public:
  void begin(int index, int height) {
    height_ = static_cast<std::size_t>(height);
    firstColumn_ = index * Strip::kColumns;
    pixels_.resize(height_ * (Strip::kColumns + 1));
    const auto second = pixels_.begin() + static_cast<std::ptrdiff_t>(height_);
    std::copy(pixels_.end() - static_cast<std::ptrdiff_t>(height_), pixels_.end(), pixels_.begin());
    std::fill(second, pixels_.end(), ShownPixel{});
  }

  int firstColumn() const { return firstColumn_; }
  int height() const { return static_cast<int>(height_); }

  /// By its place in the picture; before the first strip's first column nothing shows.
  ShownPixel& at(int column, int row) { return pixels_[indexOf(column, row)]; }
  const ShownPixel& at(int column, int row) const { return pixels_[indexOf(column, row)]; }

 private:
  std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(column + 1 - firstColumn_) * height_ +
           static_cast<std::size_t>(row);
  }

  int firstColumn_ = 0;
  std::size_t height_ = 0;
  std::vector<ShownPixel> pixels_;
};

}  // namespace hearth
