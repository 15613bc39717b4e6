#include "light/lightmap.h"

#include <algorithm>
#include <utility>

namespace hearth {

namespace {

bool isGrey(const std::vector<std::uint8_t>& levels) {
  for (std::size_t i = 0; i < levels.size(); i += 3)
    if (levels[i] != levels[i + 1] || levels[i + 1] != levels[i + 2]) return false;
  return true;
}

std::vector<std::uint8_t> everyThird(const std::vector<std::uint8_t>& levels) {
  std::vector<std::uint8_t> kept;
  kept.reserve(levels.size() / 3);
  for (std::size_t i = 0; i < levels.size(); i += 3) kept.push_back(levels[i]);
  return kept;
}

}  // namespace

Lightmap compacted(Lightmap map) {
  if (map.isUniform()) return map;
  const auto second = map.levels.begin() + map.channels;
  // Whether each texel is as the one before.
  if (std::equal(second, map.levels.end(), map.levels.begin()))
    map.levels = {map.levels.begin(), second};
  return map;
}

std::optional<Lightmap> simplified(Lightmap map) {
  if (std::ranges::all_of(map.levels, [](std::uint8_t level) { return level == 0; }))
    return std::nullopt;
  if (map.channels == 3 && isGrey(map.levels)) map = {map.rect, everyThird(map.levels), 1};
  return compacted(std::move(map));
}

}  // namespace hearth
