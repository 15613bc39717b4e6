#pragma once

#include <optional>
#include <vector>

#include "level/level.h"
#include "light/light_sum.h"
#include "light/lightmap.h"

namespace hearth {

/// The light of a surface while it is added up: a sum for each texel and channel.
class TexelSums {
 public:
  /// With one channel all lights must be white or grey.
  TexelSums(TexelRect rect, int channels);

  /// Of a light in all its channels, to the texel (i, j); `level` >= 0, before colour.
  void add(int i, int j, const LightSource& light, double level) {
    LightSum* sum = &sums_[index(i, j)];
    for (int channel = 0; channel < channels_; ++channel)
      sum[channel].add(level * light.share(channel));
  }

  /// Of texels that lie among these; one channel goes to all.
  void add(const TexelSums& other);
  /// The same without rows and columns at the borders that are dark.
  TexelSums cropped() const;
  std::size_t bytes() const { return sums_.size() * sizeof(LightSum); }

  /// The means of so many samples a texel, in 8 or 16 bits. None where all is dark; one channel
  /// where no coloured light has arrived.
  std::optional<Lightmap> toLightmap(int samples, int bits) const;

 private:
  bool isTexelDark(int i, int j) const;
  std::size_t index(int i, int j) const {
    return (static_cast<std::size_t>(j - rect_.j0) * static_cast<std::size_t>(rect_.width) +
            static_cast<std::size_t>(i - rect_.i0)) *
           static_cast<std::size_t>(channels_);
  }

  TexelRect rect_;
  int channels_;
  std::vector<LightSum> sums_;  ///< row by row, the channels of a texel side by side
};

}  // namespace hearth
