#include "light/lightmap.h"

#include <utility>

namespace hearth {

KeptLightmap::KeptLightmap(Lightmap map) : Lightmap(std::move(map)) {
  if (isEven()) return;
  // Alike are all texels when each is as the one before.
  if (std::equal(levels.begin() + channels, levels.end(), levels.begin()))
    levels = {levels.begin(), levels.begin() + channels};
}

}  // namespace hearth
