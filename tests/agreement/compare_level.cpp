#include "agreement/compare_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "agreement/plain_texels.h"
#include "light/bakery.h"
#include "load/load.h"
#include "random_levels/random_level.h"
#include "render/renderer.h"
#include "truth/truth_view.h"

namespace hearth::agreement {

namespace {

constexpr double kEdgePx = 0.02;  ///< pixels so near to an edge may show either side
/// Metres around a sample. One on an edge is taken a micrometre inside it, and in a corner the
/// format does not say which way: two that are both right lie less than two of these apart.
/// Elsewhere only rounding moves a sample: that of coordinates, and the 10^-7 m that the bakery
/// leaves before it. Where many pixels are excused, a light, a wall and a row of samples are in one
/// line: 406 pixels of a sloped floor of seed 1949, where that line is y = 2.125.
constexpr std::array kHairs{1e-6, 2e-6};
constexpr double kStep = 0.25;      ///< levels: more is a shadow's edge, so near to a sample
constexpr double kNearLight = 0.3;  ///< metres around a light where light changes too fast
/// Levels: half for the rounding of texels, half for that of pixels, both of which can be exact
/// halves; and what doubles add to that.
constexpr double kGridTolerance = 1 + 1e-9;
/// Levels. Where some of the four texels clip at full light and some do not, this cannot hold:
/// along a line between two centres h apart, light that falls by g levels a metre passes 255
/// somewhere, p of the way. Interpolated between 255 and 255 - (1 - p) g h it misses min(255, .)
/// there by p (1 - p) g h, which is up to g h / 4. A light of falloff f that passes 255 at distance
/// d falls by g = 255 f / (d f + 1) there: with f = 1 and d = 0.3 m by 196, which makes 6 levels at
/// h = 1/8 m.
constexpr double kExactTolerance = 3;
constexpr double kFineTexel = 0.125;  ///< metres: exact light is promised up to this texel
constexpr int kLightStride = 7;       ///< light is compared on every so many pixels

/// Compares one level, whose light is baked once for all views.
class Comparison {
 public:
  Comparison(const LoadedLevel& loaded, std::string_view name)
      : level_(loaded.level),
        textures_(loaded.textures),
        name_(name),
        light_(bake(level_, level_.bake, 1)),
        renderer_(level_, textures_, light_),
        truthLight_(level_),
        texels_(level_) {}

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
    const std::optional<Patch> found = patchAt(hit);
    if (!found) return;
    const Patch& patch = *found;
    const double drawn = view.lit.at(i, j).r;
    const double sector = level_[hit.sector].light;
    const auto shown = [&](double level) { return 255 * std::min(1.0, level / 255 + sector); };
    const auto atEdge = [&] {
      return !view.truth.isClear(i + 0.5, j + 0.5, kEdgePx) || isAtShadowEdge(patch);
    };
    const bool same = std::abs(drawn - shown(patch.interpolated())) <= kGridTolerance;
    count(kind.gridLight, same, atEdge, [&] { noteMiss(view, "light at texels", i, j); });

    if (const std::optional<LeftOut> why = whyLeftOut(patch, hit)) {
      ++tally_.leftOut[static_cast<std::size_t>(*why)];
      return;
    }
    const double exact = shown(std::clamp(truthLight_.at(hit).x, 0.0, 255.0));
    count(kind.exactLight, std::abs(drawn - exact) <= kExactTolerance, atEdge,
          [&] { noteMiss(view, "exact light", i, j); });
  }

  /// Truth's light at the four texels around a point.
  struct Patch : TexelPatch {
    std::array<double, 4> levels{};
    int clipped = 0;  ///< how many of them are more than full

    double interpolated() const {
      return std::inner_product(levels.begin(), levels.end(), weights().begin(), 0.0);
    }
  };

  std::optional<Patch> patchAt(const TruthHit& hit) {
    const std::optional<TexelPatch> texels = texels_.around(hit);
    if (!texels) return std::nullopt;
    Patch patch{*texels};
    for (std::size_t k = 0; k < 4; ++k) {
      const double level = truthLight_.at(patch.samples[k]).x;
      patch.levels[k] = std::min(level, 255.0);
      patch.clipped += level > 255 ? 1 : 0;
    }
    return patch;
  }

  bool isAtShadowEdge(const Patch& patch) const {
    return std::ranges::any_of(patch.samples, [&](const SurfacePoint& place) {
      const double here = truthLight_.at(place).x;
      return std::ranges::any_of(kHairs, [&](double hair) {
        return std::ranges::any_of(texels_.ringAround(place, hair), [&](const SurfacePoint& moved) {
          return std::abs(truthLight_.at(moved).x - here) > kStep;
        });
      });
    });
  }

  /// Why exact light is not compared at a pixel, if it is not.
  std::optional<LeftOut> whyLeftOut(const Patch& patch, const TruthHit& hit) const {
    if (level_.bake.texel > kFineTexel) return LeftOut::CoarseTexel;
    for (const LightSource& light : level_.lights)
      if (length(light.position - hit.point) < kNearLight) return LeftOut::NearLight;
    for (std::size_t light = 0; light < level_.lights.size(); ++light) {
      const bool seen = truthLight_.from(light, hit) > 0;
      for (const SurfacePoint& place : patch.samples)
        if ((truthLight_.from(light, place) > 0) != seen) return LeftOut::ShadowEdge;
    }
    if (patch.clipped != 0 && patch.clipped != 4) return LeftOut::Clip;
    if (missBeyondEdge(patch) > kExactTolerance - kGridTolerance) return LeftOut::BeyondEdge;
    return std::nullopt;
  }

  /// Levels by which the texels' light is another than where their centres are, at the pixel:
  /// samples from beyond an edge take the light of the nearest point of the surface.
  double missBeyondEdge(const Patch& patch) const {
    double miss = 0;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t light = 0; light < level_.lights.size(); ++light) {
        if (truthLight_.from(light, patch.samples[k]) == 0) continue;
        SurfacePoint center = patch.samples[k];
        center.point = patch.centers[k];
        miss += patch.weights()[k] * std::abs(truthLight_.unshaded(light, center) -
                                              truthLight_.unshaded(light, patch.samples[k]));
      }
    return miss;
  }

  void noteMiss(const View& view, std::string_view what, int i, int j) {
    if (tally_.firstMiss.empty())
      tally_.firstMiss =
          fmt::format("{} at pixel {},{} of shot {} of {}", what, i, j, view.shot.name, name_);
  }

  const Level& level_;
  const std::vector<Image>& textures_;
  std::string_view name_;
  BakedLight light_;
  Renderer renderer_;
  TruthLight truthLight_;
  PlainTexels texels_;
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
