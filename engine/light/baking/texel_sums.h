#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "level/level.h"
#include "light/lightmap.h"

namespace hearth {

/// The light of a surface while it is added up: a sum for each texel and channel.
class TexelSums {
 public:
  /// If there is one channel, all lights must be white or grey.
  TexelSums(TexelRect rect, int channels);

  /// Adds a light, in all channels, to the texel (i, j); `level` >= 0, before colour.
  void add(int i, int j, const LightSource& light, double level);
  /// The same for texels from (i, j) on, in a row.
  void addRow(int i, int j, const LightSource& light, std::span<const double> levels);

  /// Adds sums of some of these texels; one channel is added to all.
  void add(const TexelSums& other);
  bool isDark() const;
  /// Around all texels that are not dark; of size 0 where there are none.
  TexelRect litTexels() const;
  /// The same without dark rows and columns at the borders.
  TexelSums cropped() const;
  std::size_t bytes() const { return sums_.size() * sizeof(double); }

  const TexelRect& rect() const { return rect_; }
  int channels() const { return channels_; }
  /// In units of LightSum, whole numbers from 0 to LightSum::kFull: channel by channel, row by row.
  std::span<const double> units() const { return sums_; }
  std::span<double> units() { return sums_; }
  /// Those of one channel in `count` texels from (i, j) on, in a row.
  std::span<const double> unitsInRow(int channel, int i, int j, int count) const {
    return std::span(sums_).subspan(index(i, j, channel), static_cast<std::size_t>(count));
  }

  /// The means of so many samples a texel. None if all is dark; one channel if no coloured light
  /// has arrived.
  std::optional<Lightmap> toLightmap(int samples) const;
  /// Writes those of `count` texels from (i, j) on, in a row, into a lightmap of as many channels
  /// that keeps all its texels.
  void round(int i, int j, int count, int samples, Lightmap& map) const;

 private:
  std::size_t index(int i, int j, int channel) const {
    const auto row = static_cast<std::size_t>(channel) * static_cast<std::size_t>(rect_.height) +
                     static_cast<std::size_t>(j - rect_.j0);
    return row * static_cast<std::size_t>(rect_.width) + static_cast<std::size_t>(i - rect_.i0);
  }

  TexelRect rect_;
  int channels_;
  std::vector<double> sums_;  ///< see units()
};

}  // namespace hearth
