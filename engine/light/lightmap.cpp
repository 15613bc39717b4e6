#include "light/lightmap.h"

#include <algorithm>

namespace hearth {

Lightmap asKept(Lightmap map) {
  const auto second = map.levels.begin() + map.channels;
  // Alike are all texels when each is as the one before.
  if (!map.isEven() && std::equal(second, map.levels.end(), map.levels.begin()))
    map.levels = {map.levels.begin(), second};
  return map;
}

}  // namespace hearth
