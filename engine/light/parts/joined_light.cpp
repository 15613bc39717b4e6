#include "light/parts/joined_light.h"

#include <algorithm>
#include <utility>

#include "light/baking/baked_surface.h"
#include "light/baking/mesh_light.h"
#include "light/baking/sprite_light.h"
#include "light/baking/surface_places.h"
#include "light/used_texels.h"

namespace hearth {

JoinedLight::JoinedLight(const Scene& scene, const BakeSettings& settings, LitSurfaces surfaces,
                         std::vector<LitMesh> meshes)
    : scene_(scene),
      settings_(settings),
      sectorsOfMeshes_(sectorsOfMeshes(scene.level())),
      atlases_(meshes.size()) {
  light_.surfaces = std::move(surfaces);
  light_.meshes = std::move(meshes);
  light_.lightmaps.resize(light_.surfaces.size());
}

bool JoinedLight::add(const LightTile& tile, TexelSums sums) {
  if (first_ && !first_->isOfSameMap(tile)) finishMap();
  if (!first_) first_ = tile;
  if (sums.isDark()) return true;
  if (!sums_.empty() && sums_.front().channels() != sums.channels()) return false;
  sums_.push_back(std::move(sums));
  return true;
}

BakedLight JoinedLight::taken() {
  if (first_) finishMap();
  for (std::size_t i = 0; i < atlases_.size(); ++i)
    light_.lightmaps[light_.meshes[i].surface.index()] = atlasOf(light_.meshes[i], atlases_[i]);
  light_.stats = statsOf(light_);
  return std::move(light_);
}

void JoinedLight::finishMap() {
  const auto& [kind, index, piece, texels, cost] = *first_;
  std::optional<Lightmap> map = mapAtHand();
  if (kind == LightTile::Kind::Surface)
    light_.lightmaps[index] = std::move(map);
  else if (kind == LightTile::Kind::Sprite)
    light_.lightmaps[scene_.level().sprites[index].surface.index()] = std::move(map);
  else if (kind == LightTile::Kind::Patch)
    atlases_[index].push_back({&light_.meshes[index].patches[piece], {}, std::move(map)});
  else
    atlases_[index].push_back(
        {nullptr, smallFacesAtOnce(light_.meshes[index])[piece], std::move(map)});
  first_.reset();
  sums_.clear();
}

std::optional<Lightmap> JoinedLight::mapAtHand() const {
  const auto& [kind, index, piece, texels, cost] = *first_;
  if (kind == LightTile::Kind::Surface)
    return mapOf(SurfacePlaces(scene_, light_.surfaces, SurfaceId(index)));
  if (kind == LightTile::Kind::Patch) {
    const LitSurfaces patch{light_.meshes[index].patches[piece].surface};
    return mapOf(PatchPlaces(scene_, sectorsOfMeshes_[index], patch));
  }
  // Small faces and sprites are one tile, of which rows and columns without light are left out.
  constexpr int kChannels = 3;
  TexelSums all(texels, kChannels);
  for (const TexelSums& sums : sums_) all.add(sums);
  return all.toLightmap(1);
}

template <typename Places>
std::optional<Lightmap> JoinedLight::mapOf(const Places& places) const {
  const UsedTexels texels(places.surface(), places.surface().texels);
  return lightmapOf(places, sums_, texels, settings_);
}

}  // namespace hearth
