#include "image/halved.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace hearth {

namespace {

/// One axis of a picture that is made smaller. Lengths are in units of which a pixel of the large
/// picture is `small` long and one of the small picture `large`: so all are whole.
struct Axis {
  std::int64_t large;
  std::int64_t small;

  int first(int pixel) const { return static_cast<int>(pixel * large / small); }
  int last(int pixel) const { return static_cast<int>(((pixel + 1) * large - 1) / small); }
  /// How much of a pixel of the large picture one of the small picture covers.
  std::int64_t overlap(int ofSmall, int ofLarge) const {
    const std::int64_t begin = std::max(ofSmall * large, ofLarge * small);
    const std::int64_t end = std::min((ofSmall + 1) * large, (ofLarge + 1) * small);
    return end - begin;
  }
};

Rgb meanOf(const Image& image, const Axis& across, int x, const Axis& down, int y) {
  std::int64_t whole = 0;
  std::array<std::int64_t, 3> sums{};
  for (int j = down.first(y); j <= down.last(y); ++j)
    for (int i = across.first(x); i <= across.last(x); ++i) {
      const std::int64_t weight = across.overlap(x, i) * down.overlap(y, j);
      const Rgb color = image.at(i, j);
      whole += weight;
      sums[0] += weight * color.r;
      sums[1] += weight * color.g;
      sums[2] += weight * color.b;
    }
  const auto mean = [&](std::int64_t sum) {
    return static_cast<std::uint8_t>((2 * sum + whole) / (2 * whole));
  };
  return {mean(sums[0]), mean(sums[1]), mean(sums[2])};
}

}  // namespace

Image halved(const Image& image) {
  const Axis across{image.width(), std::max(1, image.width() / 2)};
  const Axis down{image.height(), std::max(1, image.height() / 2)};
  Image half(static_cast<int>(across.small), static_cast<int>(down.small));
  for (int y = 0; y < half.height(); ++y)
    for (int x = 0; x < half.width(); ++x) half.at(x, y) = meanOf(image, across, x, down, y);
  return half;
}

}  // namespace hearth
