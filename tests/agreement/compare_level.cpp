#include "agreement/compare_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "light/bakery.h"
#include "light/sample_placement.h"
#include "load/load.h"
#include "random_levels/random_level.h"
#include "render/renderer.h"
#include "truth/truth_view.h"

namespace hearth::agreement {

namespace {

constexpr double kEdgePx = 0.02;      ///< pixels so near to an edge may show either side
constexpr double kEdgeMetres = 1e-5;  ///< samples so near to a shadow's edge may be lit or not
constexpr double kNearLight = 0.3;    ///< metres around a light where light changes too fast
/// Levels: half for the rounding of texels, half for that of pixels, both of which can be exact
/// halves; and what doubles add to that.
constexpr double kGridTolerance = 1 + 1e-9;
constexpr double kExactTolerance = 3;  ///< levels
constexpr double kFineTexel = 0.125;   ///< metres: exact light is promised up to this texel
constexpr int kLightStride = 7;        ///< light is compared on every so many pixels

/// Compares one level, whose light is baked once for all views.
class Comparison {
 public:
  Comparison(const LoadedLevel& loaded, std::string_view name)
      : level_(loaded.level),
        textures_(loaded.textures),
        name_(name),
        light_(bake(level_, level_.bake, 1)),
        renderer_(level_, textures_, light_),
        truthLight_(level_) {}

  Tally run(std::size_t shots) {
    tally_.levels = 1;
    for (std::size_t i = 0; i < std::min(shots, level_.shots.size()); ++i)
      compareView(level_.shots[i]);
    return tally_;
  }

 private:
  struct View {
    const Shot& shot;
    TruthView truth;
    Image textured;
    Image lit;
    Image coverage;
  };

  void compareView(const Shot& shot) {
    ++tally_.views;
    const Camera camera = cameraOf(shot);
    const View view{
        shot, TruthView(level_, textures_, shot), renderer_.draw(camera, LightMode::None),
        renderer_.draw(camera, LightMode::Only), renderer_.draw(camera, Channel::Overdraw)};
    for (int j = 0; j < shot.height; ++j)
      for (int i = 0; i < shot.width; ++i) comparePixel(view, i, j);
  }

  void comparePixel(const View& view, int i, int j) {
    const TruthPixel pixel = view.truth.pixel(i + 0.5, j + 0.5, TruthLightMode::None);
    KindTally& kind = tally_.kinds[static_cast<std::size_t>(pixel.hit.kind)];
    if (view.coverage.at(i, j) == kHole) {
      ++tally_.holes;
      noteMiss(view, "hole", i, j);
    }
    const auto atEdge = [&] { return !view.truth.isClear(i + 0.5, j + 0.5, kEdgePx); };
    const bool same = view.textured.at(i, j) == pixel.color;
    count(kind.texture, same, atEdge, [&] { noteMiss(view, "texture", i, j); });
    const bool chosen = (j * view.shot.width + i) % kLightStride == 0;
    if (chosen && same && !isSky(pixel.hit.kind)) compareLight(view, pixel.hit, kind, i, j);
  }

  template <typename AtEdge, typename OnMiss>
  static void count(Count& count, bool same, AtEdge&& atEdge, OnMiss&& onMiss) {
    if (!same && atEdge()) {
      ++count.excused;
      return;
    }
    ++count.tested;
    if (same) return;
    ++count.missed;
    onMiss();
  }

  void compareLight(const View& view, const TruthHit& hit, KindTally& kind, int i, int j) {
    const std::optional<SurfaceId> surface = surfaceOf(hit);
    if (!surface) return;  // the textures agree by chance on another surface: no light to compare
    const Patch patch = patchAt(*surface, hit.point);
    const double drawn = view.lit.at(i, j).r;
    const double sector = level_[hit.sector].light;
    const auto shown = [&](double level) { return 255 * std::min(1.0, level / 255 + sector); };
    const auto atEdge = [&] {
      return !view.truth.isClear(i + 0.5, j + 0.5, kEdgePx) || isAtShadowEdge(patch);
    };
    const bool same = std::abs(drawn - shown(patch.interpolated())) <= kGridTolerance;
    count(kind.gridLight, same, atEdge, [&] { noteMiss(view, "light at texels", i, j); });

    if (level_.bake.texel > kFineTexel || isUnsteady(patch, hit)) return;
    const double exact = shown(std::clamp(truthLight_.at(hit).x, 0.0, 255.0));
    count(kind.exactLight, std::abs(drawn - exact) <= kExactTolerance, atEdge,
          [&] { noteMiss(view, "exact light", i, j); });
  }

  /// The surface that truth hit, by what it is and where.
  std::optional<SurfaceId> surfaceOf(const TruthHit& hit) const {
    for (const SurfaceId id : surfacesOf(hit.sector)) {
      const Surface& surface = level_[id];
      if (surface.kind != hit.kind || surface.segment != hit.segment) continue;
      if (!surface.segment) return id;
      if (hit.point.z >= surface.zBottom - 1e-6 && hit.point.z <= surface.zTop + 1e-6) return id;
    }
    return std::nullopt;
  }

  const std::vector<SurfaceId>& surfacesOf(SectorId sector) const {
    if (surfacesBySector_.empty()) {
      surfacesBySector_.resize(level_.sectors.size());
      for (std::size_t i = 0; i < level_.surfaces.size(); ++i)
        if (light_.surfaces[i])
          surfacesBySector_[level_.surfaces[i].sector.index()].push_back(SurfaceId(i));
    }
    return surfacesBySector_[sector.index()];
  }

  /// Truth's light at the four texel centres around a point.
  struct Patch {
    std::array<SurfacePoint, 4> places;
    std::array<double, 4> levels;
    int clipped;  ///< how many of them are more than full
    double fs;
    double ft;

    double interpolated() const {
      const double upper = levels[0] + fs * (levels[1] - levels[0]);
      const double lower = levels[2] + fs * (levels[3] - levels[2]);
      return upper + ft * (lower - upper);
    }
  };

  Patch patchAt(SurfaceId id, Vec3 point) {
    const LitSurface& lit = *light_.surfaces[id.index()];
    const Vec2 texels = lit.grid.toTexels(point);
    const double i = std::floor(texels.x - 0.5);
    const double j = std::floor(texels.y - 0.5);
    Patch patch{{}, {}, 0, texels.x - 0.5 - i, texels.y - 0.5 - j};
    for (std::size_t k = 0; k < 4; ++k) {
      const Texel& texel =
          texelAt(id, {i + static_cast<double>(k % 2) + 0.5, j + static_cast<double>(k / 2) + 0.5});
      patch.places[k] = texel.place;
      patch.levels[k] = texel.level;
      patch.clipped += texel.clips ? 1 : 0;
    }
    return patch;
  }

  struct Texel {
    SurfacePoint place;
    double level;
    bool clips;
  };

  const Texel& texelAt(SurfaceId id, Vec2 center) {
    const auto [entry, isNew] = texels_.try_emplace({id, center.x, center.y});
    if (isNew) {
      const SamplePoint at = SamplePlacement(light_.surfaces, id).place(center);
      const Surface& surface = level_[at.surface];
      const LitSurface& lit = *light_.surfaces[at.surface.index()];
      entry->second.place = {surface.kind, surface.sector, surface.segment, at.target, lit.normal};
      const double level = truthLight_.at(entry->second.place).x;
      entry->second.level = std::min(level, 255.0);
      entry->second.clips = level > 255;
    }
    return entry->second;
  }

  bool isAtShadowEdge(const Patch& patch) const {
    return std::ranges::any_of(patch.places, [&](const SurfacePoint& place) {
      const double here = truthLight_.at(place).x;
      for (const Vec3 way : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        for (const double sign : {-1.0, 1.0}) {
          const Vec3 inPlane = way - dot(way, place.normal) * place.normal;
          SurfacePoint moved = place;
          moved.point = place.point + (sign * kEdgeMetres) * inPlane;
          if (std::abs(truthLight_.at(moved).x - here) > 0.25) return true;
        }
      return false;
    });
  }

  /// A light is near, or between the texels and the pixel runs an edge: of its shadow, or of where
  /// light is full and clips.
  bool isUnsteady(const Patch& patch, const TruthHit& hit) const {
    if (patch.clipped != 0 && patch.clipped != 4) return true;
    for (std::size_t light = 0; light < level_.lights.size(); ++light) {
      if (length(level_.lights[light].position - hit.point) < kNearLight) return true;
      const bool seen = truthLight_.from(light, hit) > 0;
      for (const SurfacePoint& place : patch.places)
        if ((truthLight_.from(light, place) > 0) != seen) return true;
    }
    return false;
  }

  void noteMiss(const View& view, std::string_view what, int i, int j) {
    if (tally_.firstMiss.empty())
      tally_.firstMiss =
          fmt::format("{} at pixel {},{} of shot {} of {}", what, i, j, view.shot.name, name_);
  }

  struct TexelKey {
    SurfaceId surface;
    double i;
    double j;
    auto operator<=>(const TexelKey&) const = default;
  };

  const Level& level_;
  const std::vector<Image>& textures_;
  std::string_view name_;
  BakedLight light_;
  Renderer renderer_;
  TruthLight truthLight_;
  std::map<TexelKey, Texel> texels_;
  mutable std::vector<std::vector<SurfaceId>> surfacesBySector_;
  Tally tally_;
};

}  // namespace

Tally compareLevel(const LoadedLevel& loaded, std::string_view name, std::size_t shots) {
  return Comparison(loaded, name).run(shots);
}

Tally compareRandomLevel(std::uint64_t seed, const std::filesystem::path& folder) {
  const RandomLevel random = makeRandomLevel(seed);
  Tally failed;
  failed.firstMiss = fmt::format("seed {} does not load", seed);
  failed.holes = 1;
  if (!writeRandomLevel(folder, random)) return failed;
  const LoadResult result = loadLevel(folder / (random.name + ".json"));
  std::filesystem::remove(folder / (random.name + ".json"));
  std::filesystem::remove(folder / (random.name + ".lights.json"));
  return result.loaded ? compareLevel(*result.loaded, fmt::format("seed {}", seed), 4) : failed;
}

}  // namespace hearth::agreement
