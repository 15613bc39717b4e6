#include "light/lightmap.h"

#include <algorithm>

namespace hearth {

namespace {

/// Whether each texel of so many bytes is as the one before.
bool isEven(const std::vector<std::uint8_t>& texels, std::ptrdiff_t bytes) {
  return texels.empty() || std::equal(texels.begin() + bytes, texels.end(), texels.begin());
}

}  // namespace

Lightmap asKept(Lightmap map) {
  if (map.isEven() || !isEven(map.levels, map.channels) || !isEven(map.fractions, map.channels))
    return map;
  for (std::vector<std::uint8_t>* texels : {&map.levels, &map.fractions})
    if (!texels->empty()) *texels = {texels->begin(), texels->begin() + map.channels};
  return map;
}

}  // namespace hearth
