#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "light/lit_surface.h"

namespace hearth {

/// The light on one surface: a byte for each texel and channel, row by row, the channels of a texel
/// side by side. White light has one channel, which stands for all three.
struct Lightmap {
  TexelRect rect;
  std::vector<std::uint8_t> levels;  ///< of all texels, or of one that stands for all
  int channels = 1;                  ///< or 3: red, green, blue

  /// True where one texel stands for all.
  bool isUniform() const { return levels.size() == static_cast<std::size_t>(channels); }
  std::size_t bytes() const { return levels.size(); }

  std::uint8_t at(int i, int j, int channel = 0) const { return levels[indexOf(i, j, channel)]; }

  /// All texels black, each kept.
  static Lightmap dark(const TexelRect& rect, int channels) {
    const std::size_t bytes =
        static_cast<std::size_t>(rect.count()) * static_cast<std::size_t>(channels);
    return {rect, std::vector<std::uint8_t>(bytes), channels};
  }
  /// The levels of texel (i, j), where all texels are kept.
  std::uint8_t* texel(int i, int j) { return &levels[indexOf(i, j, 0)]; }
  /// Gives the texel (toI, toJ) the light of (i, j).
  void copyTexel(int i, int j, int toI, int toJ) {
    std::copy_n(texel(i, j), channels, texel(toI, toJ));
  }

  /// Light of a channel in levels (0..255) at texel coordinates, interpolated between texel
  /// centres. `rect` has all texels around points of the surface; a point that rounding puts beyond
  /// the edge is moved back to it.
  double sample(double s, double t, int channel = 0) const {
    const double across = std::clamp(s - (rect.i0 + 0.5), 0.0, rect.width - 1.0);
    const double down = std::clamp(t - (rect.j0 + 0.5), 0.0, rect.height - 1.0);
    const int i = std::min(static_cast<int>(across), rect.width - 2);
    const int j = std::min(static_cast<int>(down), rect.height - 2);
    const auto level = [&](int texel, int row) -> double {
      return at(rect.i0 + texel, rect.j0 + row, channel);
    };
    const double above = std::lerp(level(i, j), level(i + 1, j), across - i);
    const double below = std::lerp(level(i, j + 1), level(i + 1, j + 1), across - i);
    return std::lerp(above, below, down - j);
  }

 private:
  std::size_t indexOf(int i, int j, int channel) const {
    const std::size_t texel =
        isUniform() ? 0
                    : static_cast<std::size_t>(j - rect.j0) * static_cast<std::size_t>(rect.width) +
                          static_cast<std::size_t>(i - rect.i0);
    return channels == 1 ? texel : 3 * texel + static_cast<std::size_t>(channel);
  }
};

/// The same light, stored as one texel if all are equal. Lightmaps are kept and drawn so.
Lightmap compacted(Lightmap map);
/// The same, with one channel if all is grey; none if all is dark.
std::optional<Lightmap> simplified(Lightmap map);

}  // namespace hearth
