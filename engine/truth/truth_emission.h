#pragma once

#include <vector>

#include "level/level.h"
#include "truth/trace.h"

namespace hearth {

/// What surfaces shine with that wear the textures of emitters.
class TruthEmission {
 public:
  explicit TruthEmission(const Level& level);

  /// Levels (255 is full) of red, green and blue, from the front of what a ray meets.
  Vec3 of(const TruthHit& hit) const;

 private:
  std::vector<Vec3> levels_;  ///< by TextureId
};

}  // namespace hearth
