#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/halved.h"
#include "image/image.h"
#include "image/pixel_rows.h"
#include "render/draw_settings.h"

namespace hearth {

/// Set in texels that are holes.
inline constexpr std::uint32_t kHoleBit = std::uint32_t{1} << 31;

/// An image as spans read it: pixels as in PixelRows, column by column, so that the rows of a wall
/// in one column of the picture lie side by side.
class Texture {
 public:
  using Texel = std::uint32_t;  ///< a pixel, and kHoleBit where it is a hole

  explicit Texture(const Image& image) : width_(image.width()), height_(image.height()) {
    texels_.reserve(image.pixels().size());
    for (int x = 0; x < width_; ++x)
      for (int y = 0; y < height_; ++y)
        texels_.push_back(toXrgb(image.at(x, y)) | (image.isHole(x, y) ? kHoleBit : 0));
  }

  int width() const { return width_; }
  int height() const { return height_; }
  /// The texel (x, y) is the one of number x * height() + y.
  const Texel* texels() const { return texels_.data(); }

 private:
  int width_;
  int height_;
  std::vector<Texel> texels_;
};

/// A texture in several sizes, each half as wide and high as the one before: mip levels.
class MipMap {
 public:
  /// Only the full size.
  explicit MipMap(const Image& image) : levels_{Texture(image)} {}
  /// All sizes down to a single texel.
  static MipMap withAllSizes(Image image) {
    MipMap sizes(image);
    while (image.width() > 1 || image.height() > 1) {
      image = halved(image);
      sizes.levels_.emplace_back(image);
    }
    return sizes;
  }

  const Texture& full() const { return levels_.front(); }
  /// 0 is the full size; numbers past the smallest give the smallest.
  const Texture& level(int number) const {
    return levels_[std::min(static_cast<std::size_t>(number), levels_.size() - 1)];
  }

 private:
  std::vector<Texture> levels_;
};

/// The textures of a level as renderers read them, by TextureId. All renderers of a level can share
/// them.
using DrawnTextures = std::shared_ptr<const std::vector<MipMap>>;
DrawnTextures drawnTextures(const std::vector<Image>& images, TextureFilter filter);

}  // namespace hearth
