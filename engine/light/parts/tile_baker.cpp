#include "light/parts/tile_baker.h"

#include <cstddef>
#include <cstdint>
#include <vector>

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

/// By light: the part of the map in which the tiles that it reaches ask what it sees.
std::vector<Box> regionsOf(const LevelInTiles& level, std::span<const LightTile> tiles) {
  // Texels that samples lie outside their tile. Beams give no answer for those farther away.
  constexpr double kMostMoved = 4;
  std::vector<Box> regions(level.reach.lights());
  for (const LightTile& tile : tiles) {
    if (tile.map.kind != LightMapId::Kind::Surface) continue;  // things ask no beams
    const LitSurface& surface = *level.surfaces[tile.map.index];
    const Box3 box = boxAround(surface, tile.texels).grownBy(kMostMoved * surface.grid.texel);
    for (const std::size_t light : level.reach.reaching(box)) {
      regions[light].add(box.min.xy());
      regions[light].add(box.max.xy());
    }
  }
  return regions;
}

}  // namespace

TileBaker::TileBaker(const Bounces& bounces, const BakeSettings& settings,
                     const LevelInTiles& level, std::span<const LightTile> tiles, int threads)
    : scene_(bounces.scene()),
      settings_(settings),
      level_(level),
      visibilities_(scene_, settings, level.reach, regionsOf(level, tiles),
                    LightVisibilities::Purpose::Bake, [&bounces] { return bounces.irradiance(); }),
      lighter_(scene_, visibilities_, settings, threads, meshesOfTiles(tiles), level.meshes) {}

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
  SurfaceLight surface(scene_, level_.surfaces, visibilities_, settings_.lambert,
                       SurfaceId(tile.map.index));
  for (const std::size_t light : surface.facing(tile.texels)) visibilities_.prefetchBeams(light);
  return sumsOfTile(surface, tile.texels, settings_);
}

TexelSums TileBaker::ofPatch(const LightTile& tile) const {
  const LitSurfaces patch{level_.meshes[tile.map.index].patches[tile.map.piece].surface};
  const MeshPlace place = lighter_.placeOf(tile.map.index);
  PatchLight light(scene_, visibilities_, settings_.lambert, place, patch);
  return sumsOfTile(light, tile.texels, settings_);
}

TexelSums TileBaker::ofSmallFaces(const LightTile& tile) const {
  const MeshPlace place = lighter_.placeOf(tile.map.index);
  CornerLight corners(scene_, visibilities_, settings_.lambert, place);
  return corners.find(smallFacesAtOnce(level_.meshes[tile.map.index])[tile.map.piece]);
}

TexelSums TileBaker::ofSprite(const LightTile& tile) const {
  std::int64_t rays = 0;
  return lightOfSprite(scene_, visibilities_, scene_.level().sprites[tile.map.index], rays);
}

}  // namespace hearth
