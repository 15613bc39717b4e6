#include "image/compare.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "math/check.h"

namespace hearth {
namespace {

int levelsApart(Rgb a, Rgb b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

void checkSameSize(const Image& a, const Image& b) {
  CHECK(a.width() == b.width() && a.height() == b.height(), a.width(), a.height(), b.width(),
        b.height());
}

std::uint8_t amplified(int a, int b) {
  return a == b ? 0 : static_cast<std::uint8_t>(std::min(255, 64 + 24 * std::abs(a - b)));
}

/// A mask of the pixels that differ. Patches are taken out of it one by one.
class DifferenceMask {
 public:
  DifferenceMask(int width, int height)
      : width_(width),
        height_(height),
        set_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  void set(std::size_t pixel) { set_[pixel] = true; }

  std::int64_t largestPatch() {
    std::int64_t largest = 0;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) largest = std::max(largest, takePatch(x, y));
    }
    return largest;
  }

 private:
  struct Pixel {
    int x;
    int y;
  };

  /// Clears the patch that holds the pixel and returns its size.
  std::int64_t takePatch(int x, int y) {
    take(x, y);
    std::int64_t size = 0;
    for (; !pending_.empty(); ++size) {
      const Pixel pixel = pending_.back();
      pending_.pop_back();
      take(pixel.x - 1, pixel.y);
      take(pixel.x + 1, pixel.y);
      take(pixel.x, pixel.y - 1);
      take(pixel.x, pixel.y + 1);
    }
    return size;
  }

  void take(int x, int y) {
    if (x < 0 || x >= width_ || y < 0 || y >= height_) return;
    const std::size_t index = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(x);
    if (!set_[index]) return;
    set_[index] = false;
    pending_.push_back({x, y});
  }

  int width_;
  int height_;
  std::vector<bool> set_;
  std::vector<Pixel> pending_;
};

}  // namespace

PictureDifference compare(const Image& expected, const Image& actual, int patchThreshold) {
  checkSameSize(expected, actual);
  PictureDifference difference;
  DifferenceMask mask(expected.width(), expected.height());
  for (std::size_t i = 0; i < expected.pixels().size(); ++i) {
    const int levels = levelsApart(expected.pixels()[i], actual.pixels()[i]);
    if (levels == 0) continue;
    if (levels > patchThreshold) mask.set(i);
    ++difference.differing;
    difference.over2 += levels > 2 ? 1 : 0;
    difference.over8 += levels > 8 ? 1 : 0;
    difference.largest = std::max(difference.largest, levels);
  }
  if (difference.largest > patchThreshold) difference.largestPatch = mask.largestPatch();
  return difference;
}

Image amplifiedDifference(const Image& expected, const Image& actual) {
  checkSameSize(expected, actual);
  Image difference(expected.width(), expected.height());
  for (int y = 0; y < expected.height(); ++y) {
    for (int x = 0; x < expected.width(); ++x) {
      const Rgb a = expected.at(x, y);
      const Rgb b = actual.at(x, y);
      difference.at(x, y) = {amplified(a.r, b.r), amplified(a.g, b.g), amplified(a.b, b.b)};
    }
  }
  return difference;
}

}  // namespace hearth
