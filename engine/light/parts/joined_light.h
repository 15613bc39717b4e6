#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "level/bake_settings.h"
#include "level/scene.h"
#include "light/bakery.h"
#include "light/baking/atlas_light.h"
#include "light/baking/texel_sums.h"
#include "light/parts/light_tile.h"

namespace hearth {

/// Puts lightmaps together from the sums of their tiles.
class JoinedLight {
 public:
  JoinedLight(const Scene& scene, const BakeSettings& settings, LitSurfaces surfaces,
              std::vector<LitMesh> meshes);

  /// Call it for all tiles of a level, in their order. False if the light of one map is white in
  /// some of its tiles and coloured in others, which no bake writes.
  bool add(const LightTile& tile, TexelSums sums);
  /// All light, once.
  BakedLight taken();

 private:
  void finishMap();
  std::optional<Lightmap> mapAtHand() const;
  template <typename Places>
  std::optional<Lightmap> mapOf(const Places& places) const;

  Scene scene_;
  BakeSettings settings_;
  BakedLight light_;
  std::vector<std::vector<SectorId>> sectorsOfMeshes_;
  std::vector<std::vector<PartOfAtlas>> atlases_;  ///< by mesh
  std::optional<LightTile> first_;                 ///< of the map at hand, ...
  std::vector<TexelSums> sums_;                    ///< ... and those of its tiles that are lit
};

}  // namespace hearth
