#pragma once

#include <vector>

#include "level/scene.h"
#include "level/sprite.h"

namespace hearth {

/// Finds the sectors that sprites are in. Keeps its memory from one to the next.
class SpriteSectors {
 public:
  /// Those of a sprite, its own first: each opening that its image crosses, or touches, leads from
  /// a sector that it is in to another. Valid until the next call.
  const std::vector<SectorId>& find(const Scene& scene, const Sprite& sprite,
                                    const SpriteRect& rect);

 private:
  std::vector<SectorId> sectors_;
  std::vector<double> cuts_;
};

}  // namespace hearth
