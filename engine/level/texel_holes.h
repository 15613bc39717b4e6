#pragma once

#include <cstddef>
#include <vector>

namespace hearth {

/// Which texels of an image are holes. If it has no size, no texel is a hole.
class TexelHoles {
 public:
  TexelHoles() = default;
  TexelHoles(int width, int height)
      : width_(width),
        height_(height),
        holes_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  bool isHole(int x, int y) const { return !holes_.empty() && holes_[index(x, y)]; }
  void setHole(int x, int y) { holes_[index(x, y)] = true; }
  const std::vector<bool>& bits() const { return holes_; }  ///< row by row, row 0 on top

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<bool> holes_;
};

}  // namespace hearth
