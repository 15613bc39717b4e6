#pragma once

#include <algorithm>
#include <cmath>
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

  /// Light of a channel in levels (0..255) at texel coordinates, interpolated between texel
  /// centres.
  double sample(double s, double t, int channel = 0) const {
    if (planted(PlantedBug::LightmapHalfTexelOff)) s += 0.5, t += 0.5;
    const double left = std::floor(s - 0.5);
    const double top = std::floor(t - 0.5);
    // Clamped only against rounding on the very edge: `rect` has all texels of the surface.
    const int i = std::clamp(static_cast<int>(left), rect.i0, rect.i0 + rect.width - 2);
    const int j = std::clamp(static_cast<int>(top), rect.j0, rect.j0 + rect.height - 2);
    const double fs = std::clamp(s - 0.5 - i, 0.0, 1.0);
    const double ft = std::clamp(t - 0.5 - j, 0.0, 1.0);
    const auto mixed = [&](int row) {
      const double before = at(i, row, channel);
      return before + fs * (at(i + 1, row, channel) - before);
    };
    const double upper = mixed(j);
    return upper + ft * (mixed(j + 1) - upper);
  }
};

}  // namespace hearth
