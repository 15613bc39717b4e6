#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "level/level.h"
#include "truth/trace.h"

namespace hearth {

/// The meshes of a level. Each ray tries every face of those that are in its sector.
///
/// Works from what the author says of each, so that the renderer can be compared with it.
class TruthMeshes {
 public:
  /// Keeps a reference to the level.
  explicit TruthMeshes(const Level& level);

  /// What a look from `origin` meets of them in a stretch of air: the nearest face that is seen
  /// from its front, or of a two-sided mesh from either side; of two meshes at one depth the later.
  /// What bounds the stretch and is no nearer is behind them. `direction` goes 1 m deep before the
  /// camera: so the parameters of its ray are depths.
  ///
  /// Faces that share corners leave no gap between them. A hit's depth is between those of its
  /// face's corners, whatever the rounding.
  std::optional<TruthHit> nearest(Vec3 origin, Vec3 direction, const AirStretch& stretch) const;

 private:
  const Level& level_;
  std::vector<std::vector<bool>> isIn_;  ///< of all meshes in their order, by SectorId
};

}  // namespace hearth
