#include "light/parts/tile_baker.h"

#include <cstddef>
#include <cstdint>

#include "light/baking/baked_surface.h"
#include "light/baking/corner_light.h"
#include "light/baking/patch_light.h"
#include "light/baking/sprite_light.h"
#include "light/baking/surface_light.h"
#include "math/check.h"

namespace hearth {

namespace {

/// The meshes that some tiles are of, each once.
std::vector<std::uint32_t> meshesOfTiles(std::span<const LightTile> tiles) {
  std::vector<std::uint32_t> meshes;
  for (const LightTile& tile : tiles)
    if (tile.map.isOfMesh() && (meshes.empty() || meshes.back() != tile.map.index))
      meshes.push_back(tile.map.index);
  return meshes;
}

}  // namespace

TileBaker::TileBaker(const Scene& scene, const BakeSettings& settings, const LevelInTiles& level,
                     std::span<const LightTile> tiles, int threads)
    : scene_(scene),
      settings_(settings),
      level_(level),
      lighter_(scene, level.visibilities, settings, threads, meshesOfTiles(tiles), level.meshes) {}

TexelSums TileBaker::baked(const LightTile& tile) const {
  switch (tile.map.kind) {
    case LightMapId::Kind::Surface:
      return ofSurface(tile);
    case LightMapId::Kind::Patch:
      return ofPatch(tile);
    case LightMapId::Kind::SmallFaces:
      return ofSmallFaces(tile);
    case LightMapId::Kind::Sprite:
      return ofSprite(tile);
  }
  CHECK(false, static_cast<int>(tile.map.kind));
}

TexelSums TileBaker::ofSurface(const LightTile& tile) const {
  SurfaceLight surface(scene_, level_.surfaces, level_.visibilities, settings_.lambert,
                       SurfaceId(tile.map.index));
  for (const std::size_t light : surface.facing(tile.texels))
    level_.visibilities.fine[light].prefetchBeams();
  return sumsOfTile(surface, tile.texels, settings_);
}

TexelSums TileBaker::ofPatch(const LightTile& tile) const {
  const LitSurfaces patch{level_.meshes[tile.map.index].patches[tile.map.piece].surface};
  const MeshPlace place = lighter_.placeOf(tile.map.index);
  PatchLight light(scene_, level_.visibilities, settings_.lambert, place, patch);
  return sumsOfTile(light, tile.texels, settings_);
}

TexelSums TileBaker::ofSmallFaces(const LightTile& tile) const {
  const MeshPlace place = lighter_.placeOf(tile.map.index);
  CornerLight corners(scene_, level_.visibilities, settings_.lambert, place);
  return corners.find(smallFacesAtOnce(level_.meshes[tile.map.index])[tile.map.piece]);
}

TexelSums TileBaker::ofSprite(const LightTile& tile) const {
  std::int64_t rays = 0;
  return lightOfSprite(scene_, level_.visibilities, scene_.level().sprites[tile.map.index], rays);
}

}  // namespace hearth
