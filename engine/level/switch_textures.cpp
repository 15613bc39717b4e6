#include "level/switch_textures.h"

#include <algorithm>

namespace hearth {

void showSwitches(Level& level, std::span<const double> shares) {
  const std::vector<SwitchTexture>& all = level.switchTextures;
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(first, all.end(), [&](const SwitchTexture& other) {
      return other.surface != first->surface;
    });
    const auto on =
        std::find_if(first, last, [&](const SwitchTexture& of) { return shares[of.mover] > 0; });
    level.surfaces[first->surface.index()].mapping.texture = on == last ? first->off : on->on;
    first = last;
  }
}

}  // namespace hearth
