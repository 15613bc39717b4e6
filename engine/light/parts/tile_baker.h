#pragma once

#include <span>
#include <vector>

#include "level/bake_settings.h"
#include "level/scene.h"
#include "light/baking/bounces.h"
#include "light/baking/light_visibility.h"
#include "light/baking/mesh_light.h"
#include "light/baking/texel_sums.h"
#include "light/parts/light_tile.h"

namespace hearth {

/// Bakes some tiles of a level, each by itself. Any thread may call it.
class TileBaker {
 public:
  /// Keeps references to all but `tiles`.
  TileBaker(const Bounces& bounces, const BakeSettings& settings, const LevelInTiles& level,
            std::span<const LightTile> tiles, int threads);

  /// The light of one of them.
  TexelSums baked(const LightTile& tile) const;

 private:
  TexelSums ofSurface(const LightTile& tile) const;
  TexelSums ofPatch(const LightTile& tile) const;
  TexelSums ofSmallFaces(const LightTile& tile) const;
  TexelSums ofSprite(const LightTile& tile) const;

  Scene scene_;
  const BakeSettings& settings_;
  const LevelInTiles& level_;
  LightVisibilities visibilities_;  ///< of the lights that the tiles ask
  MeshLighter lighter_;
};

}  // namespace hearth
