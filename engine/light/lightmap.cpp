#include "light/lightmap.h"

#include <algorithm>

namespace hearth {

Lightmap compacted(Lightmap map) {
  if (map.isUniform()) return map;
  const auto second = map.levels.begin() + map.channels;
  // Whether each texel is as the one before.
  if (std::equal(second, map.levels.end(), map.levels.begin()))
    map.levels = {map.levels.begin(), second};
  return map;
}

}  // namespace hearth
