#include "light/texel_sums.h"

#include <algorithm>
#include <utility>

namespace hearth {

namespace {

bool isGrey(const Lightmap& map) {
  for (std::size_t i = 0; i < map.levels.size(); i += 3)
    if (map.levels[i] != map.levels[i + 1] || map.levels[i + 1] != map.levels[i + 2]) return false;
  return true;
}

Lightmap withOneChannel(const Lightmap& map) {
  Lightmap white{map.rect, {}, 1};
  white.levels.reserve(map.levels.size() / 3);
  for (std::size_t i = 0; i < map.levels.size(); i += 3) white.levels.push_back(map.levels[i]);
  return white;
}

}  // namespace

TexelSums::TexelSums(TexelRect rect, int channels)
    : rect_(rect),
      channels_(channels),
      sums_(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height) *
            static_cast<std::size_t>(channels)) {}

std::optional<Lightmap> TexelSums::toLightmap(int samples) const {
  Lightmap map{rect_, {}, channels_};
  map.levels.reserve(sums_.size());
  for (const LightSum& sum : sums_) map.levels.push_back(sum.mean(samples));
  if (std::ranges::all_of(map.levels, [](std::uint8_t level) { return level == 0; }))
    return std::nullopt;
  return asKept(channels_ == 3 && isGrey(map) ? withOneChannel(map) : map);
}

}  // namespace hearth
