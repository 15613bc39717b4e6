#include "light/baking/texel_sums.h"

#include <algorithm>
#include <array>
#include <utility>

#include "light/baking/brightness_kernels.h"
#include "light/baking/light_sum.h"

namespace hearth {

TexelSums::TexelSums(TexelRect rect, int channels)
    : rect_(rect),
      channels_(channels),
      sums_(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height) *
            static_cast<std::size_t>(channels)) {}

void TexelSums::add(int i, int j, const LightSource& light, double level) {
  for (int channel = 0; channel < channels_; ++channel) {
    double& units = sums_[index(i, j, channel)];
    LightSum sum(units);
    sum.add(level * light.colorFactor(channel));
    units = sum.units();
  }
}

void TexelSums::addRow(int i, int j, const LightSource& light, std::span<const double> levels) {
  for (int channel = 0; channel < channels_; ++channel)
    brightnessKernels().addToSums(levels.data(), levels.size(), light.colorFactor(channel),
                                  &sums_[index(i, j, channel)]);
}

void TexelSums::add(const TexelSums& other) {
  for (int channel = 0; channel < channels_; ++channel)
    for (int j = other.rect_.j0; j < other.rect_.j0 + other.rect_.height; ++j)
      for (int i = other.rect_.i0; i < other.rect_.i0 + other.rect_.width; ++i) {
        double& units = sums_[index(i, j, channel)];
        LightSum sum(units);
        sum.add(LightSum(other.sums_[other.index(i, j, other.channels_ == 1 ? 0 : channel)]));
        units = sum.units();
      }
}

TexelRect TexelSums::litTexels() const {
  const auto isLit = [](double units) { return units > 0; };
  int left = rect_.width;
  int right = 0;
  int top = rect_.height;
  int bottom = 0;
  for (int channel = 0; channel < channels_; ++channel)
    for (int j = 0; j < rect_.height; ++j) {
      const auto row = unitsInRow(channel, rect_.i0, rect_.j0 + j, rect_.width);
      const auto first = std::ranges::find_if(row, isLit);
      if (first == row.end()) continue;
      const auto afterLast = std::find_if(row.rbegin(), row.rend(), isLit).base();
      left = std::min(left, static_cast<int>(first - row.begin()));
      right = std::max(right, static_cast<int>(afterLast - row.begin()));
      top = std::min(top, j);
      bottom = std::max(bottom, j + 1);
    }
  if (right == 0) return {rect_.i0, rect_.j0, 0, 0};
  return {rect_.i0 + left, rect_.j0 + top, right - left, bottom - top};
}

TexelSums TexelSums::cropped() const {
  TexelSums part(litTexels(), channels_);
  const TexelRect& lit = part.rect_;
  for (int channel = 0; channel < channels_; ++channel)
    for (int j = lit.j0; j < lit.j0 + lit.height; ++j)
      std::ranges::copy(unitsInRow(channel, lit.i0, j, lit.width),
                        &part.sums_[part.index(lit.i0, j, channel)]);
  return part;
}

bool TexelSums::isDark() const {
  return std::ranges::all_of(sums_, [](double units) { return units == 0; });
}

void TexelSums::round(int i, int j, int count, int samples, Lightmap& map) const {
  const auto channels = static_cast<std::size_t>(channels_);
  std::array<double, 64> means;
  for (int channel = 0; channel < channels_; ++channel) {
    std::uint8_t* level = map.texel(i, j) + channel;
    auto sums = unitsInRow(channel, i, j, count);
    while (!sums.empty()) {
      const auto some = sums.first(std::min(sums.size(), means.size()));
      brightnessKernels().findMeans(some.data(), some.size(), samples, means.data());
      for (const double mean : std::span(means).first(some.size())) {
        *level = static_cast<std::uint8_t>(mean);
        level += channels;
      }
      sums = sums.subspan(some.size());
    }
  }
}

std::optional<Lightmap> TexelSums::toLightmap(int samples) const {
  Lightmap map = Lightmap::dark(rect_, channels_);
  for (int j = rect_.j0; j < rect_.j0 + rect_.height; ++j)
    round(rect_.i0, j, rect_.width, samples, map);
  return simplified(std::move(map));
}

}  // namespace hearth
