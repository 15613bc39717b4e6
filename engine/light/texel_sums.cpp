#include "light/texel_sums.h"

#include <algorithm>
#include <utility>

namespace hearth {

namespace {

using Texels = std::vector<std::uint8_t>;

bool isGrey(const Texels& texels) {
  for (std::size_t i = 0; i < texels.size(); i += 3)
    if (texels[i] != texels[i + 1] || texels[i + 1] != texels[i + 2]) return false;
  return true;
}

Texels everyThird(const Texels& texels) {
  Texels kept;
  kept.reserve(texels.size() / 3);
  for (std::size_t i = 0; i < texels.size(); i += 3) kept.push_back(texels[i]);
  return kept;
}

bool isDark(const Texels& texels) {
  return std::ranges::all_of(texels, [](std::uint8_t byte) { return byte == 0; });
}

}  // namespace

TexelSums::TexelSums(TexelRect rect, int channels)
    : rect_(rect),
      channels_(channels),
      sums_(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height) *
            static_cast<std::size_t>(channels)) {}

std::optional<Lightmap> TexelSums::toLightmap(int samples, int bits) const {
  Lightmap map{rect_, {}, channels_};
  map.levels.reserve(sums_.size());
  if (bits == 8) {
    for (const LightSum& sum : sums_) map.levels.push_back(sum.mean(samples));
  } else {
    map.fractions.reserve(sums_.size());
    for (const LightSum& sum : sums_) {
      const std::uint16_t level = sum.fineMean(samples);
      map.levels.push_back(static_cast<std::uint8_t>(level >> 8));
      map.fractions.push_back(static_cast<std::uint8_t>(level));
    }
  }
  if (isDark(map.levels) && isDark(map.fractions)) return std::nullopt;
  if (channels_ == 3 && isGrey(map.levels) && isGrey(map.fractions))
    map = {rect_, everyThird(map.levels), 1, everyThird(map.fractions)};
  return asKept(std::move(map));
}

}  // namespace hearth
