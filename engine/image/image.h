#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hearth {

/// Width and height in pixels.
struct ImageSize {
  int width = 0;
  int height = 0;

  friend constexpr bool operator==(ImageSize, ImageSize) = default;
};

struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  friend constexpr bool operator==(Rgb, Rgb) = default;
};

/// A picture of 8-bit RGB pixels, row by row, row 0 on top. A pixel can be a hole, through
/// which masked textures show what lies behind; it has a colour all the same.
class Image {
 public:
  Image() = default;
  Image(int width, int height, Rgb fill = {})
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Rgb at(int x, int y) const { return pixels_[index(x, y)]; }
  Rgb& at(int x, int y) { return pixels_[index(x, y)]; }
  const std::vector<Rgb>& pixels() const { return pixels_; }

  bool hasHoles() const { return !holes_.empty(); }
  bool isHole(int x, int y) const { return hasHoles() && holes_[index(x, y)]; }
  void makeHole(int x, int y) {
    holes_.resize(pixels_.size());
    holes_[index(x, y)] = true;
  }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Rgb> pixels_;
  std::vector<bool> holes_;  ///< empty where there are none
};

}  // namespace hearth
