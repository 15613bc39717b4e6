#include "area_light/compare_areas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "light/bakery.h"
#include "light/baking/mesh_light.h"
#include "light/baking/surface_places.h"
#include "math/check.h"
#include "random_levels/random.h"
#include "random_levels/random_level.h"
#include "truth/truth_gather.h"
#include "truth/truth_light.h"

namespace hearth::area_light {

namespace {

constexpr int kTexelsOfSurface = 4;
constexpr int kSmallFacesOfMesh = 6;
constexpr TruthGather::Effort kEffort{.side = 24, .rounds = 6, .seed = 1};

/// Surfaces that wear every other texture, by little enough for lightmaps.
void addEmitters(Level& level) {
  for (std::size_t i = 0; i < level.textures.size(); i += 2) {
    LightSource emitter;
    emitter.texture = level.textures[i];
    emitter.intensity = 60 + 40.0 * static_cast<double>(i % 4);
    level.lights.push_back(emitter);
  }
}

/// Lit by points, which truth finds fast, whose light is added to that of areas.
Level withBounces(Level level) {
  for (LightSource& light : level.lights) light.radius = 0;
  level.bake.bounces = 3;
  level.bake.samples = 1;
  return level;
}

BakeSettings withoutBounces(BakeSettings settings) {
  settings.bounces = 0;
  return settings;
}

/// Without lights that are no areas, and one sample to a texel: its middle.
Level withAreasOnly(Level level, Areas areas) {
  if (areas == Areas::Bounces) return withBounces(std::move(level));
  std::erase_if(level.lights, [&](const LightSource& light) {
    return areas == Areas::Emitters || !light.isArea();
  });
  if (areas == Areas::Emitters) {
    addEmitters(level);
  } else if (level.lights.empty()) {
    LightSource sky;
    sky.isSky = true;
    sky.intensity = 200;
    level.lights.push_back(sky);
  }
  level.bake.samples = 1;
  return level;
}

class Comparison {
 public:
  Comparison(Level level, const Geometry& geometry, std::string_view name)
      : level_(std::move(level)),
        scene_(level_, geometry),
        name_(name),
        baked_(bake(scene_, level_.bake, 1)),
        unbounced_(bake(scene_, withoutBounces(level_.bake), 1)),
        direct_(level_),
        gather_(level_, direct_),
        sectors_(sectorsOfMeshes(level_)),
        random_(level_.surfaces.size()) {
    tally_.levels = 1;
    for (const LightCost& cost : baked_.lightCosts) {
      tally_.slices += cost.rays;
      tally_.samples += cost.samples;
    }
  }

  AreaTally compare() {
    for (std::size_t i = 0; i < level_.surfaces.size(); ++i)
      if (baked_.surfaces[i]) compareSurface(SurfaceId(i));
    for (std::uint32_t i = 0; i < level_.meshes.size(); ++i) compareMesh(i);
    for (const Sprite& sprite : level_.sprites) compareSprite(sprite);
    return tally_;
  }

 private:
  std::string placeOf(SurfaceKind kind, SectorId sector, Vec3 p) const {
    return fmt::format("{}: {} of {} at {:.3f} {:.3f} {:.3f}", name_, name(kind),
                       level_[sector].name, p.x, p.y, p.z);
  }

  /// In the first channel: all light, clamped as lightmaps are, or what bounces has added to what
  /// is not clamped. `lightOf` tells the light of a bake there.
  template <typename LightOf, typename Place>
  void add(SurfaceKind kind, LightOf&& lightOf, const Place& place, const std::string& at) {
    const double baked = lightOf(baked_);
    const auto [light, error] = gather_.at(place, kEffort);
    if (level_.bake.bounces == 0)
      return tally_.add(kind, baked, std::min(255.0, light.sum().x), error.sum().x, at);
    if (baked < 255)
      tally_.add(kind, baked - lightOf(unbounced_), light.bounced.x, error.bounced.x, at);
  }

  void compareSurface(SurfaceId id) {
    const SurfacePlaces places(scene_, baked_.surfaces, id);
    const LitSurface& lit = *baked_.surfaces[id.index()];
    for (int k = 0; k < kTexelsOfSurface; ++k) {
      const int i = lit.texels.i0 + static_cast<int>(random_.between(0, lit.texels.width - 1));
      const int j = lit.texels.j0 + static_cast<int>(random_.between(0, lit.texels.height - 1));
      const SamplePoint at = places.place({i + 0.5, j + 0.5});
      if (at.isMoved || places.isLeftOut(at) || !lit.outline.contains({i + 0.5, j + 0.5})) continue;
      const Surface& there = level_[at.surface];
      const SurfacePoint place{there.kind, there.sector, there.segment, at.target,
                               baked_.surfaces[at.surface.index()]->normal};
      add(
          level_[id].kind,
          [&](const BakedLight& baked) {
            const std::optional<Lightmap>& map = baked.lightmaps[id.index()];
            return map ? map->at(i, j) : 0;
          },
          place, placeOf(level_[id].kind, there.sector, at.point));
    }
  }

  void compareMesh(std::uint32_t index) {
    const LitMesh& lit = baked_.meshes[index];
    for (const LitMesh::Patch& patch : lit.patches) compareTexel(index, patch);
    for (int k = 0; k < kSmallFacesOfMesh && !lit.smallFaces.empty(); ++k)
      compareSmallFace(index, lit.smallFaces[random_.below(lit.smallFaces.size())].face);
  }

  /// Of a patch: one that has a point of some face.
  void compareTexel(std::uint32_t index, const LitMesh::Patch& patch) {
    const Mesh& mesh = level_.meshes[index];
    const std::uint32_t face = mesh.firstFace + patch.faces[random_.below(patch.faces.size())];
    const auto& [a, b, c] = level_.meshFaces[face].corners;
    const Vec2 texel = patch.surface.grid.toTexels((1 / 3.0) * (a + b + c));
    const int i = static_cast<int>(std::floor(texel.x));
    const int j = static_cast<int>(std::floor(texel.y));
    const LitSurfaces alone{patch.surface};
    const SamplePoint at = PatchPlaces(scene_, sectors_[index], alone).place({i + 0.5, j + 0.5});
    if (at.isMoved) return;
    const TexelRect& rect = patch.surface.texels;
    compareFace(index, face, at.point, [&](const Lightmap& map) {
      return map.at(patch.i + i - rect.i0, patch.j + j - rect.j0);
    });
  }

  /// In its middle, if light is found at all of its corners.
  void compareSmallFace(std::uint32_t index, std::uint32_t face) {
    const Mesh& mesh = level_.meshes[index];
    const MeshFace& its = level_.meshFaces[mesh.firstFace + face];
    const auto isFound = [&](Vec3 corner) { return isInAir(scene_, sectors_[index], corner); };
    if (!std::ranges::all_of(its.corners, isFound)) return;
    const auto& [a, b, c] = its.corners;
    const Vec3 middle = (1 / 3.0) * (a + b + c);
    const Vec2 at = placeOn(baked_.meshes[index], face, its, middle);
    compareFace(index, mesh.firstFace + face, middle,
                [&](const Lightmap& map) { return map.sample(at.x, at.y); });
  }

  template <typename LightOf>
  void compareFace(std::uint32_t index, std::uint32_t face, Vec3 p, LightOf&& lightOf) {
    if (!isInAir(scene_, sectors_[index], p)) return;
    const Mesh& mesh = level_.meshes[index];
    const Vec3 front = frontOf(level_.meshFaces[face]);
    SurfacePoint place{SurfaceKind::Mesh, mesh.sector, std::nullopt, p,
                       (1 / length(front)) * front};
    place.mesh = mesh.surface;
    place.face = face;
    add(
        SurfaceKind::Mesh,
        [&](const BakedLight& baked) -> double {
          const std::optional<Lightmap>& map = baked.lightmaps[mesh.surface.index()];
          return map ? lightOf(*map) : 0;
        },
        place, placeOf(SurfaceKind::Mesh, mesh.sector, p));
  }

  void compareSprite(const Sprite& sprite) {
    const Vec3 p = lightPointOf(scene_, sprite);
    const SurfaceKind kind = level_[sprite.surface].kind;
    add(
        kind,
        [&](const BakedLight& baked) {
          const std::optional<Lightmap>& map = baked.lightmaps[sprite.surface.index()];
          return map ? map->at(0, 0) : 0;
        },
        AirPoint{p, sprite.sector}, placeOf(kind, sprite.sector, p));
  }

  Level level_;
  Scene scene_;
  std::string name_;
  BakedLight baked_;
  BakedLight unbounced_;
  TruthLight direct_;
  TruthGather gather_;
  std::vector<std::vector<SectorId>> sectors_;  ///< by mesh
  random_levels::Random random_;
  AreaTally tally_;
};

bool hasSky(const Level& level) {
  return std::ranges::any_of(level.sectors, [](const Sector& sector) {
    return sector.ceiling.isSky || sector.floor.isSky;
  });
}

}  // namespace

AreaTally compareAreas(LoadedLevel loaded, Areas areas, std::string_view name) {
  return Comparison(withAreasOnly(std::move(loaded.level), areas), loaded.geometry, name).compare();
}

AreaTally compareRandomLevel(std::uint64_t seed, Areas areas, const std::filesystem::path& folder) {
  const RandomLevel random = makeRandomLevel(seed);
  CHECK(writeRandomLevel(folder, random), seed);
  LoadResult result = loadLevel(folder / (random.name + ".json"));
  CHECK(result.loaded, seed);
  std::filesystem::remove(folder / (random.name + ".json"));
  std::filesystem::remove(folder / (random.name + ".lights.json"));
  if (areas == Areas::Sky && !hasSky(result.loaded->level)) return {};
  return compareAreas(*std::move(result.loaded), areas, fmt::format("seed {}", seed));
}

}  // namespace hearth::area_light
