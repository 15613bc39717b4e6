#include "light/parts/light_tile.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "light/baking/baked_surface.h"
#include "light/baking/lights_on_mesh.h"
#include "light/baking/sprite_light.h"
#include "light/baking/surface_light.h"
#include "math/box.h"
#include "math/box3.h"
#include "math/hilbert_curve.h"
#include "math/tolerance.h"

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

/// Tiles of a surface, without those that have no used texel.
std::vector<TexelRect> tilesIn(const LitSurface& surface) {
  constexpr int kSide = 96;
  std::vector<TexelRect> tiles = tilesOf(surface.texels, kSide);
  if (tiles.size() == 1) return tiles;
  std::erase_if(tiles, [&](const TexelRect& tile) {
    const Vec2 first{tile.i0 - 1.0, tile.j0 - 1.0};
    return !surface.outline.mayMeet({first, first + Vec2{tile.width + 2.0, tile.height + 2.0}});
  });
  return tiles;
}

/// About which share of its texels bilinear filtering can read.
double usedShareOf(const LitSurface& surface) {
  return std::min(1.0, surface.outline.areaNear(1) / static_cast<double>(surface.texels.count()));
}

Vec2 centerOf(const Box3& box) { return 0.5 * (box.min.xy() + box.max.xy()); }

class TileList {
 public:
  TileList(const Scene& scene, const LightReach& reach, const BakeSettings& settings)
      : scene_(scene), reach_(reach), settings_(settings) {}

  /// Along a Hilbert curve, so that tiles near one another on the map mostly follow soon.
  std::vector<LightTile> inOrder() const {
    Box around;
    for (const Placed& placed : tiles_) around.add(placed.center);
    const double cell = std::max(around.longerSide(), kPositionSlack) / kHilbertCells;
    const auto cellAt = [cell](double offset) {
      return static_cast<std::uint32_t>(std::clamp(offset / cell, 0.0, kHilbertCells - 1.0));
    };
    std::vector<std::pair<std::uint32_t, std::size_t>> order;
    for (const Placed& placed : tiles_) {
      const Vec2 at = placed.center - around.min;
      order.emplace_back(placeOnHilbertCurve(cellAt(at.x), cellAt(at.y)), order.size());
    }
    std::ranges::sort(order);
    std::vector<LightTile> tiles;
    tiles.reserve(order.size());
    for (const auto& [place, i] : order) tiles.push_back(tiles_[i].tile);
    return tiles;
  }

  void addSurface(const LitSurface& surface, std::uint32_t index) {
    const std::vector<std::size_t> facing = lightsFacing(scene_, reach_, surface);
    if (facing.empty()) return;
    const double samples = samplesPerTexel(surface);
    const std::vector<TexelRect> tiles = tilesIn(surface);
    std::vector<std::size_t> reachingRow = facing;  // of tiles
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      const Box3 box = boxAround(surface, tiles[i]);
      if (tiles.size() > 1 && (i == 0 || tiles[i - 1].j0 != tiles[i].j0)) {
        const TexelRect& all = surface.texels;
        const TexelRect row{all.i0, tiles[i].j0, all.width, tiles[i].height};
        reachingRow = reach_.reaching(boxAround(surface, row), facing);
      }
      const LightCounts lights = counted(reachingRow, [&](std::size_t light) {
        return tiles.size() == 1 || reach_.reaches(light, box);
      });
      add({{LightMapId::Kind::Surface, index, 0}, tiles[i]}, samples, lights, kOfSurface,
          centerOf(box));
    }
  }

  void addMesh(const LitMesh& mesh, std::uint32_t index) {
    const Box3 box = boxOf(scene_.level(), mesh);
    const LightCounts lights = countedReaching(box);
    for (std::uint32_t piece = 0; piece < mesh.patches.size(); ++piece) {
      const LitSurface& patch = mesh.patches[piece].surface;
      const double samples = samplesPerTexel(patch);
      for (const TexelRect& tile : tilesIn(patch))
        add({{LightMapId::Kind::Patch, index, piece}, tile}, samples, lights, kOfPatch,
            centerOf(box));
    }
    const auto faces = smallFacesAtOnce(mesh);
    for (std::uint32_t piece = 0; piece < faces.size(); ++piece) {
      const TexelRect corners{0, 0, 3, static_cast<int>(faces[piece].size())};
      add({{LightMapId::Kind::SmallFaces, index, piece}, corners}, 1, lights, kOfSmallFaces,
          centerOf(box));
    }
  }

  void addSprite(std::uint32_t index) {
    const Vec3 position = scene_.level().sprites[index].position;
    add({{LightMapId::Kind::Sprite, index, 0}, kSpriteTexel}, 1,
        countedReaching({position, position}), kOfSprite, position.xy());
  }

 private:
  template <typename Counts>
  LightCounts counted(std::span<const std::size_t> lights, Counts&& isOne) const {
    LightCounts counts;
    for (const std::size_t light : lights)
      if (isOne(light)) ++(reach_.isSoft(light) ? counts.balls : counts.points);
    return counts;
  }

  LightCounts countedReaching(const Box3& box) const {
    return counted(reach_.reaching(box), [](std::size_t) { return true; });
  }

  double samplesPerTexel(const LitSurface& surface) const {
    return settings_.samples.value_or(1) * usedShareOf(surface);
  }

  void add(LightTile tile, double samplesPerTexel, const LightCounts& lights,
           const TileTimes& times, Vec2 center) {
    const double samples = samplesPerTexel * static_cast<double>(tile.texels.count());
    const double perSample = times.sample + times.point * lights.points +
                             times.ballRay * settings_.softSamples * lights.balls;
    tile.cost = times.tile + times.light * (lights.points + lights.balls) + samples * perSample;
    tiles_.push_back({center, tile});
  }

  struct Placed {
    Vec2 center;  ///< on the map, of the tile, or of its mesh
    LightTile tile;
  };

  Scene scene_;
  const LightReach& reach_;
  const BakeSettings& settings_;
  std::vector<Placed> tiles_;
};

}  // namespace

LevelInTiles::LevelInTiles(const Scene& scene, const BakeSettings& settings, int threads)
    : surfaces(makeLitSurfaces(scene, settings.texel)),
      meshes(makeLitMeshes(scene.level(), settings.texel, threads)),
      reach(scene.lights(), settings) {
  TileList list(scene, reach, settings);
  for (std::uint32_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i]) list.addSurface(*surfaces[i], i);
  for (std::uint32_t i = 0; i < meshes.size(); ++i) list.addMesh(meshes[i], i);
  for (std::uint32_t i = 0; i < scene.level().sprites.size(); ++i) list.addSprite(i);
  tiles = list.inOrder();
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
