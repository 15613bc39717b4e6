#include "area_light/compare_areas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "light/bakery.h"
#include "light/baking/mesh_light.h"
#include "light/baking/surface_places.h"
#include "light/sectors_of_meshes.h"
#include "math/check.h"
#include "math/parallel.h"
#include "measure/light_places.h"
#include "random_levels/random.h"
#include "random_levels/random_level.h"
#include "truth/truth_gather.h"
#include "truth/truth_light.h"

namespace hearth::area_light {

namespace {

constexpr int kTexelsOfSurface = 4;
constexpr int kSmallFacesOfMesh = 6;
constexpr TruthGather::Effort kEffort{.side = 24, .rounds = 6, .seed = 1};
/// A third of that, for levels with many lights.
constexpr TruthGather::Effort kEffortOfTexel{.side = 16, .rounds = 4, .seed = 1};

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
  Comparison(Level level, const Geometry& geometry, std::string_view name, int threads)
      : level_(std::move(level)),
        scene_(level_, geometry),
        name_(name),
        baked_(bake(scene_, level_.bake, threads)),
        unbounced_(bake(scene_, withoutBounces(level_.bake), threads)),
        direct_(level_),
        gather_(level_, direct_),
        sectors_(sectorsOfMeshes(level_)),
        places_(scene_, baked_),
        random_(level_.surfaces.size()) {
    tally_.levels = 1;
    for (const LightCost& cost : baked_.lightCosts) {
      tally_.slices += cost.rays;
      tally_.samples += cost.samples;
    }
  }

  /// Some texels of each surface and patch, small faces of meshes, and sprites.
  AreaTally compareAll() {
    for (std::size_t i = 0; i < level_.surfaces.size(); ++i)
      if (baked_.surfaces[i]) compareSurface(SurfaceId(i));
    for (std::uint32_t i = 0; i < level_.meshes.size(); ++i) compareMesh(i);
    for (const Sprite& sprite : level_.sprites) compareSprite(sprite);
    return answer(1, kEffort);
  }

  /// Texels of surfaces and patches, each as likely as any other.
  AreaTally compareTexels(std::size_t count, int threads) {
    const auto isKnown = [this](const LightPlace& place) {
      const std::optional<Lightmap>& map = baked_.lightmaps[place.map.index()];
      return !isBounced() || !map || map->at(place.i, place.j) < 255;
    };
    for (const LightPlace& place : places_.some(count, isKnown)) addTexel(place);
    return answer(threads, kEffortOfTexel);
  }

 private:
  bool isBounced() const { return level_.bake.bounces > 0; }

  std::string placeOf(SurfaceKind kind, SectorId sector, Vec3 p) const {
    return fmt::format("{}: {} of {} at {:.3f} {:.3f} {:.3f}", name_, name(kind),
                       level_[sector].name, p.x, p.y, p.z);
  }

  /// In the first channel: all light, clamped as lightmaps are, or what bounces has added to what
  /// is not clamped. `lightOf` tells the light of a bake there.
  template <typename LightOf, typename Place>
  void add(SurfaceKind kind, LightOf&& lightOf, const Place& place, const std::string& at) {
    const double baked = lightOf(baked_);
    if (!isBounced())
      questions_.push_back({kind, baked, place, at});
    else if (baked < 255)
      questions_.push_back({kind, baked - lightOf(unbounced_), place, at});
  }

  /// Asks truth.
  AreaTally answer(int threads, const TruthGather::Effort& effort) {
    std::vector<TruthGather::Estimate> truth(questions_.size());
    parallelFor(questions_.size(), threads, [&](std::size_t i) {
      truth[i] = std::visit([&](const auto& place) { return gather_.at(place, effort); },
                            questions_[i].place);
    });
    for (std::size_t i = 0; i < questions_.size(); ++i) {
      const auto& [kind, baked, place, at] = questions_[i];
      const auto& [light, error] = truth[i];
      if (isBounced())
        tally_.add(kind, baked, light.bounced.x, error.bounced.x, at);
      else
        tally_.add(kind, baked, std::min(255.0, light.sum().x), error.sum().x, at);
    }
    return tally_;
  }

  void compareSurface(SurfaceId id) {
    for (int k = 0; k < kTexelsOfSurface; ++k) compareTexel(id);
  }

  void compareTexel(SurfaceId id) {
    const auto [i, j] = anyTexelOf(baked_.surfaces[id.index()]->texels);
    if (const auto place = places_.onSurface(id, i, j)) addTexel(*place);
  }

  std::pair<int, int> anyTexelOf(const TexelRect& texels) {
    const auto from = [&](int first, int count) {
      return first + static_cast<int>(random_.between(0, count - 1));
    };
    const int i = from(texels.i0, texels.width);
    return {i, from(texels.j0, texels.height)};
  }

  void addTexel(const LightPlace& place) {
    addPlace(place.map, place.point, [&](const Lightmap& map) { return map.at(place.i, place.j); });
  }

  /// `lightOf` takes its light from its lightmap.
  template <typename LightOf>
  void addPlace(SurfaceId id, const SurfacePoint& place, LightOf&& lightOf) {
    const SurfaceKind kind = level_[id].kind;
    add(
        kind,
        [&](const BakedLight& baked) -> double {
          const std::optional<Lightmap>& map = baked.lightmaps[id.index()];
          return map ? lightOf(*map) : 0;
        },
        place, placeOf(kind, place.sector, place.point));
  }

  void compareMesh(std::uint32_t index) {
    const LitMesh& lit = baked_.meshes[index];
    for (const LitMesh::Patch& patch : lit.patches) compareTexel(index, patch);
    for (int k = 0; k < kSmallFacesOfMesh && !lit.smallFaces.empty(); ++k)
      compareSmallFace(index, lit.smallFaces[random_.below(lit.smallFaces.size())].face);
  }

  void compareTexel(std::uint32_t index, const LitMesh::Patch& patch) {
    // Many a patch is small: the middles of most of its texels may lie beyond it.
    constexpr int kTries = 20;
    for (int k = 0; k < kTries; ++k) {
      const auto [i, j] = anyTexelOf(patch.surface.texels);
      if (const auto place = places_.onPatch(index, patch, i, j)) return addTexel(*place);
    }
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
    if (const auto place = places_.onFace(index, mesh.firstFace + face, middle))
      addPlace(mesh.surface, *place, [&](const Lightmap& map) { return map.sample(at.x, at.y); });
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

  /// What truth is asked.
  struct Question {
    SurfaceKind kind;
    double baked;  ///< levels
    std::variant<SurfacePoint, AirPoint> place;
    std::string at;
  };

  Level level_;
  Scene scene_;
  std::string name_;
  BakedLight baked_;
  BakedLight unbounced_;
  TruthLight direct_;
  TruthGather gather_;
  std::vector<std::vector<SectorId>> sectors_;  ///< by mesh
  LightPlaces places_;
  random_levels::Random random_;
  std::vector<Question> questions_;
  AreaTally tally_;
};

bool hasSky(const Level& level) {
  return std::ranges::any_of(level.sectors, [](const Sector& sector) {
    return sector.ceiling.isSky || sector.floor.isSky;
  });
}

}  // namespace

AreaTally compareTexels(LoadedLevel loaded, Areas areas, std::string_view name, int count,
                        int threads) {
  return Comparison(withAreasOnly(std::move(loaded.level), areas), loaded.geometry, name, threads)
      .compareTexels(static_cast<std::size_t>(count), threads);
}

AreaTally compareRandomLevel(std::uint64_t seed, Areas areas, const std::filesystem::path& folder,
                             double gatherError) {
  const RandomLevel random = makeRandomLevel(seed);
  CHECK(writeRandomLevel(folder, random), seed);
  LoadResult result = loadLevel(folder / (random.name + ".json"));
  CHECK(result.loaded, seed);
  std::filesystem::remove(folder / (random.name + ".json"));
  std::filesystem::remove(folder / (random.name + ".lights.json"));
  if (areas == Areas::Sky && !hasSky(result.loaded->level)) return {};
  result.loaded->level.bake.gatherError = gatherError;
  constexpr int kThreads = 1;  // levels are compared side by side
  return Comparison(withAreasOnly(std::move(result.loaded->level), areas), result.loaded->geometry,
                    fmt::format("seed {}", seed), kThreads)
      .compareAll();
}

}  // namespace hearth::area_light
