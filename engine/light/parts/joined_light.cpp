#include "light/parts/joined_light.h"

#include <utility>

#include "light/baking/atlas_light.h"
#include "light/baking/baked_surface.h"
#include "light/baking/mesh_light.h"
#include "light/baking/surface_places.h"
#include "light/sectors_of_meshes.h"

namespace hearth {

JoinedLight::JoinedLight(const Scene& scene, const BakeSettings& settings, LitSurfaces surfaces,
                         std::vector<LitMesh> meshes)
    : scene_(scene), settings_(settings), sectorsOfMeshes_(sectorsOfMeshes(scene.level())) {
  light_.surfaces = std::move(surfaces);
  light_.meshes = std::move(meshes);
  light_.lightmaps.resize(light_.surfaces.size());
}

bool JoinedLight::add(const LightTile& tile, const TexelSums& sums) {
  if (tile.map.isOfOneTile()) {
    // Rows and columns without light are left out of its sums.
    constexpr int kChannels = 3;
    TexelSums all(tile.texels, kChannels);
    all.add(sums);
    finished_[tile.map] = all.toLightmap(1);
    return true;
  }
  OpenMap& open =
      open_.try_emplace(tile.map, surfaceOf(tile.map), settings_.samples.value_or(1)).first->second;
  if (sums.isDark()) return true;
  if (open.channels != 0 && open.channels != sums.channels()) return false;
  open.channels = sums.channels();
  open.map.add(sums);
  return true;
}

BakedLight JoinedLight::taken() {
  for (auto& [id, open] : open_) finished_[id] = finishedMap(id, open);
  std::vector<std::vector<PartOfAtlas>> atlases(light_.meshes.size());
  for (auto& [id, map] : finished_) {
    if (id.kind == LightMapId::Kind::Surface)
      light_.lightmaps[id.index] = std::move(map);
    else if (id.kind == LightMapId::Kind::Sprite)
      light_.lightmaps[scene_.level().sprites[id.index].surface.index()] = std::move(map);
    else if (id.kind == LightMapId::Kind::Patch)
      atlases[id.index].push_back({&light_.meshes[id.index].patches[id.piece], {}, std::move(map)});
    else
      atlases[id.index].push_back(
          {nullptr, smallFacesAtOnce(light_.meshes[id.index])[id.piece], std::move(map)});
  }
  for (std::size_t i = 0; i < atlases.size(); ++i)
    light_.lightmaps[light_.meshes[i].surface.index()] = atlasOf(light_.meshes[i], atlases[i]);
  light_.stats = statsOf(light_);
  return std::move(light_);
}

const LitSurface& JoinedLight::surfaceOf(const LightMapId& id) const {
  return id.kind == LightMapId::Kind::Surface ? *light_.surfaces[id.index]
                                              : light_.meshes[id.index].patches[id.piece].surface;
}

std::optional<Lightmap> JoinedLight::finishedMap(const LightMapId& id, OpenMap& open) const {
  if (id.kind == LightMapId::Kind::Surface)
    return finishedLightmap(SurfacePlaces(scene_, light_.surfaces, SurfaceId(id.index)),
                            std::move(open.map), settings_);
  const LitSurfaces patch{surfaceOf(id)};
  return finishedLightmap(PatchPlaces(scene_, sectorsOfMeshes_[id.index], patch),
                          std::move(open.map), settings_);
}

}  // namespace hearth
