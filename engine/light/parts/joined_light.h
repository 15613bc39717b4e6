#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "level/bake_settings.h"
#include "level/scene.h"
#include "light/bakery.h"
#include "light/baking/lightmap_builder.h"
#include "light/baking/texel_sums.h"
#include "light/parts/light_tile.h"
#include "light/used_texels.h"

namespace hearth {

/// Puts lightmaps together from the sums of their tiles.
class JoinedLight {
 public:
  JoinedLight(const Scene& scene, const BakeSettings& settings, LitSurfaces surfaces,
              std::vector<LitMesh> meshes);

  /// Call it for all tiles of a level, in any order. False if the light of one map is white in some
  /// of its tiles and coloured in others, which no bake writes.
  bool add(const LightTile& tile, const TexelSums& sums);
  /// All light, once.
  BakedLight taken();

 private:
  /// A lightmap of which there may be tiles to come.
  struct OpenMap {
    OpenMap(const LitSurface& surface, int samples)
        : texels(surface, surface.texels), map(texels, samples) {}
    OpenMap(const OpenMap&) = delete;
    OpenMap& operator=(const OpenMap&) = delete;

    UsedTexels texels;
    LightmapBuilder map;
    int channels = 0;  ///< 0 until there is light
  };

  const LitSurface& surfaceOf(const LightMapId& id) const;
  std::optional<Lightmap> finishedMap(const LightMapId& id, OpenMap& open) const;

  Scene scene_;
  BakeSettings settings_;
  BakedLight light_;
  std::vector<std::vector<SectorId>> sectorsOfMeshes_;
  std::map<LightMapId, OpenMap> open_;
  std::map<LightMapId, std::optional<Lightmap>> finished_;
};

}  // namespace hearth
