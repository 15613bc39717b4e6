#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "light/lit_surface.h"
#include "math/planted_bug.h"

namespace hearth {

/// The light on one surface: 8 bits a texel and channel, row by row, the channels of a texel side
/// by side. White light has one channel, which answers for all.
struct Lightmap {
  TexelRect rect;
  std::vector<std::uint8_t> levels;
  int channels = 1;  ///< or 3: red, green, blue

  std::uint8_t at(int i, int j, int channel = 0) const {
    const std::size_t texel =
        static_cast<std::size_t>(j - rect.j0) * static_cast<std::size_t>(rect.width) +
        static_cast<std::size_t>(i - rect.i0);
    return levels[channels == 1 ? texel : 3 * texel + static_cast<std::size_t>(channel)];
  }

  /// A place between the centres of four texels.
  struct Place {
    const std::uint8_t* upper;  ///< the left one of the two above ...
    const std::uint8_t* lower;  ///< ... and of the two below
    int channels;
    double fs;  ///< 0..1, from the left texels to the right
    double ft;  ///< 0..1, from the upper to the lower

    /// Light of a channel in levels, 0..255.
    double level(int channel) const {
      const int first = channels == 1 ? 0 : channel;
      const auto mixed = [&](const std::uint8_t* texels) {
        const double before = texels[first];
        return before + fs * (texels[first + channels] - before);
      };
      const double above = mixed(upper);
      return above + ft * (mixed(lower) - above);
    }
  };

  /// Finds places in a lightmap, of which it keeps a pointer into the levels.
  class Sampler {
   public:
    explicit Sampler(const Lightmap& map)
        : levels_(map.levels.data()),
          channels_(map.channels),
          width_(map.rect.width),
          height_(map.rect.height),
          firstS_(map.rect.i0 + 0.5),
          firstT_(map.rect.j0 + 0.5) {}

    int channels() const { return channels_; }

    /// The lightmap's `rect` has all texels around points of the surface; what rounding puts beyond
    /// its edge is taken back to it.
    Place at(double s, double t) const {
      if (planted(PlantedBug::LightmapHalfTexelOff)) s += 0.5, t += 0.5;
      const double across = std::clamp(s - firstS_, 0.0, width_ - 1.0);
      const double down = std::clamp(t - firstT_, 0.0, height_ - 1.0);
      const int i = std::min(static_cast<int>(across), width_ - 2);
      const int j = std::min(static_cast<int>(down), height_ - 2);
      const std::uint8_t* upper =
          levels_ + (std::ptrdiff_t{j} * width_ + i) * std::ptrdiff_t{channels_};
      return {upper, upper + std::ptrdiff_t{width_} * channels_, channels_, across - i, down - j};
    }

   private:
    const std::uint8_t* levels_;
    int channels_;
    int width_;
    int height_;
    double firstS_;  ///< of the first texel's centre
    double firstT_;
  };

  /// Light of a channel in levels (0..255) at texel coordinates, interpolated between texel
  /// centres.
  double sample(double s, double t, int channel = 0) const {
    return Sampler(*this).at(s, t).level(channel);
  }
};

}  // namespace hearth
