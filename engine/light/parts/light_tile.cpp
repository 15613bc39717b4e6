#include "light/parts/light_tile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "light/baking/baked_surface.h"
#include "light/baking/lights_on_mesh.h"
#include "light/baking/sprite_light.h"
#include "light/baking/surface_light.h"
#include "light/used_texels.h"

namespace hearth {

namespace {

/// What a kind of tile takes, in nanoseconds: least squares over the tiles of the castle and of
/// Freedoom's MAP01 and MAP29, with lamps as balls and as points.
struct TileTimes {
  double tile;
  double light;  ///< for each light that reaches the tile
  double sample;
  double point;    ///< for each sample and point light
  double ballRay;  ///< for each sample, ball and soft sample
};
constexpr TileTimes kOfSurface{
    .tile = 0, .light = 10'000, .sample = 100, .point = 35, .ballRay = 200};
constexpr TileTimes kOfPatch{
    .tile = 25'000, .light = 0, .sample = 1'300, .point = 30, .ballRay = 35};
constexpr TileTimes kOfSmallFaces{.tile = 0, .light = 0, .sample = 600, .point = 15, .ballRay = 20};
constexpr TileTimes kOfSprite{
    .tile = 30'000, .light = 0, .sample = 0, .point = 2'000, .ballRay = 200};

/// Lights that reach a tile.
struct LightCounts {
  double points = 0;
  double balls = 0;
};

class TileList {
 public:
  TileList(const Scene& scene, const LightVisibilities& visibilities, const BakeSettings& settings)
      : scene_(scene), visibilities_(visibilities), settings_(settings) {}

  std::vector<LightTile> taken() { return std::move(tiles_); }

  void addSurface(const LitSurfaces& surfaces, std::uint32_t index) {
    const SurfaceLight light(scene_, surfaces, visibilities_, settings_.lambert, SurfaceId(index));
    if (light.facing().empty()) return;
    const UsedTexels texels(light.surface(), light.surface().texels);
    for (const TexelRect& tile : tilesOf(texels)) {
      LightCounts lights;
      for (const std::size_t i : light.facing(tile)) count(i, lights);
      add({LightTile::Kind::Surface, index, 0, tile}, samplesIn(texels, tile), lights, kOfSurface);
    }
  }

  void addMesh(const LitMesh& mesh, std::uint32_t index) {
    const Box3 box = boxOf(scene_.level(), mesh);
    const LightCounts lights = lightsNear(box);
    for (std::uint32_t piece = 0; piece < mesh.patches.size(); ++piece) {
      const LitSurface& patch = mesh.patches[piece].surface;
      const UsedTexels texels(patch, patch.texels);
      for (const TexelRect& tile : tilesOf(texels))
        add({LightTile::Kind::Patch, index, piece, tile}, samplesIn(texels, tile), lights,
            kOfPatch);
    }
    const auto faces = smallFacesAtOnce(mesh);
    for (std::uint32_t piece = 0; piece < faces.size(); ++piece) {
      const TexelRect corners{0, 0, 3, static_cast<int>(faces[piece].size())};
      add({LightTile::Kind::SmallFaces, index, piece, corners},
          static_cast<double>(corners.count()), lights, kOfSmallFaces);
    }
  }

  void addSprite(std::uint32_t index) {
    const Vec3 point = lightPointOf(scene_, scene_.level().sprites[index]);
    add({LightTile::Kind::Sprite, index, 0, kSpriteTexel}, 1, lightsNear({point, point}),
        kOfSprite);
  }

 private:
  double samplesIn(const UsedTexels& texels, const TexelRect& tile) const {
    return settings_.samples.value_or(1) * static_cast<double>(texels.countIn(tile));
  }

  void count(std::size_t light, LightCounts& lights) const {
    ++(visibilities_.fine[light].shaftLight().radius > 0 ? lights.balls : lights.points);
  }

  LightCounts lightsNear(const Box3& box) const {
    LightCounts lights;
    for (std::size_t i = 0; i < visibilities_.fine.size(); ++i)
      if (box.distanceTo(scene_.level().lights[i].position) < visibilities_.reach[i])
        count(i, lights);
    return lights;
  }

  void add(LightTile tile, double samples, const LightCounts& lights, const TileTimes& times) {
    const double perSample = times.sample + times.point * lights.points +
                             times.ballRay * settings_.softSamples * lights.balls;
    tile.cost = times.tile + times.light * (lights.points + lights.balls) + samples * perSample;
    tiles_.push_back(tile);
  }

  Scene scene_;
  const LightVisibilities& visibilities_;
  const BakeSettings& settings_;
  std::vector<LightTile> tiles_;
};

}  // namespace

LevelInTiles::LevelInTiles(const Scene& scene, const BakeSettings& settings, int threads)
    : surfaces(makeLitSurfaces(scene, settings.texel)),
      meshes(makeLitMeshes(scene.level(), settings.texel, threads)),
      visibilities(scene, settings) {
  TileList list(scene, visibilities, settings);
  for (std::uint32_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i]) list.addSurface(surfaces, i);
  for (std::uint32_t i = 0; i < meshes.size(); ++i) list.addMesh(meshes[i], i);
  for (std::uint32_t i = 0; i < scene.level().sprites.size(); ++i) list.addSprite(i);
  tiles = list.taken();
}

std::vector<std::size_t> firstTilesOf(std::uint32_t parts, const std::vector<LightTile>& tiles) {
  double all = 0;
  for (const LightTile& tile : tiles) all += tile.cost;
  std::vector<std::size_t> first{0};
  double before = 0;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    // A tile belongs to the part in which the middle of its cost lies.
    const double middle = (before + tiles[i].cost / 2) / all * parts;
    while (first.size() < parts && middle >= static_cast<double>(first.size())) first.push_back(i);
    before += tiles[i].cost;
  }
  first.resize(parts + std::size_t{1}, tiles.size());
  return first;
}

}  // namespace hearth
