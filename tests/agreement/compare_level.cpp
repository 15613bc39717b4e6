#include "agreement/compare_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "agreement/texel_truth.h"
#include "light/bakery.h"
#include "load/load.h"
#include "random_levels/random_level.h"
#include "render/renderer.h"
#include "truth/truth_view.h"

namespace hearth::agreement {

namespace {

constexpr double kEdgePx = 0.02;    ///< pixels so near to an edge may show either side
constexpr double kNearLight = 0.3;  ///< metres around a light where light changes too fast
/// With the cosine at the surface: right under a light of i levels, d above it, light interpolated
/// over texels of h misses i h^2 / (4 d^2), which at i = 255 and h = 1/8 m makes 2 levels.
constexpr double kNearLightWithCosine = 0.7;
/// Levels: half for the rounding of texels, half for that of pixels, both of which can be exact
/// halves; and the 1/40 that the renderer's 16 bits may add (tests/render/pixel_kernels_test.cpp).
constexpr double kGridTolerance = 1 + 1.0 / 40;
/// Levels. Where some of the four texels clip at full light and some do not, this cannot hold:
/// along a line between two centres h apart, light that falls by g levels a metre passes 255
/// somewhere, p of the way. Interpolated between 255 and 255 - (1 - p) g h it misses min(255, .)
/// there by p (1 - p) g h, which is up to g h / 4. A light of falloff f that passes 255 at distance
/// d falls by g = 255 f / (d f + 1) there: with f = 1 and d = 0.3 m by 196, which makes 6 levels at
/// h = 1/8 m.
constexpr double kExactTolerance = 3;
/// Levels of those three that interpolation may miss: half a level each is for rounding.
constexpr double kInterpolation = kExactTolerance - kGridTolerance;
/// ... because of curves; the rest is for light that falls smoothly.
constexpr double kInterpolationAtCurves = kInterpolation / 2;
constexpr double kFineTexel = 0.125;  ///< metres: exact light is promised up to this texel
constexpr int kLightStride = 7;       ///< light is compared on every so many pixels
constexpr int kClearStride = 31;      ///< of every so many it is asked whether edges are near

/// Levels that a channel may miss where it is not compared.
constexpr double kAny = std::numeric_limits<double>::infinity();

/// Whether each channel of the one is within its tolerance, in levels, of the other's.
bool areWithin(const Channels& tolerance, const Channels& a, const Channels& b) {
  for (std::size_t channel = 0; channel < 3; ++channel)
    if (std::abs(a[channel] - b[channel]) > tolerance[channel]) return false;
  return true;
}

Channels sum(const Channels& a, const Channels& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Channels same(double level) { return {level, level, level}; }

/// With lights and samples as truth can follow them; tests/light holds the sky against truth.
Level comparable(Level level) {
  std::erase_if(level.lights, [](const LightSource& light) { return light.isArea(); });
  for (LightSource& light : level.lights) {
    light.radius = 0;
    if (light.sun) light.sun.emplace(light.sun->angle(), light.sun->pitch(), 0);
  }
  if (!level.bake.samples) level.bake.samples = 1;
  return level;
}

/// Compares one level, whose light is baked once for all views.
class Comparison {
 public:
  Comparison(const LoadedLevel& loaded, std::string_view name)
      : level_(comparable(loaded.level)),
        scene_(level_, loaded.geometry),
        textures_(loaded.textures),
        name_(name),
        light_(bake(scene_, level_.bake, 1)),
        renderer_(scene_, textures_, light_),
        truth_(scene_) {}

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
    const bool isSame = view.textured.at(i, j) == pixel.color;
    count(kind.texture, isSame, atEdge, [&] { noteMiss(view, "texture", i, j); });
    const int index = j * view.shot.width + i;
    if (index % kClearStride == 0) {
      ++tally_.asked;
      tally_.clear += atEdge() ? 0 : 1;
    }
    if (index % kLightStride != 0) return;
    ++tally_.lightAsked;
    if (isSame && !isSky(pixel.hit.kind)) compareLight(view, pixel.hit, kind, i, j);
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
    if (hit.sprite) return compareSpriteLight(view, hit, kind, i, j);
    const std::optional<PatchLight> patch = truth_.around(hit);
    if (!patch) {
      ++kind.gridLight.missed;
      return noteMiss(view, "light of no surface", i, j);
    }
    const auto slack = [&] { return truth_.hairSlack(*patch); };
    const auto compare = [&](Count& sort, const Channels& levels, const Channels& tolerance,
                             std::string_view what) {
      const bool byHair = compareLevels(view, i, j, sort, shown(levels, level_[hit.sector].light),
                                        tolerance, slack, what);
      if (byHair && truth_.isAtJump(*patch)) ++tally_.atJumps;
    };
    const Channels grid{patch->interpolated(0), patch->interpolated(1), patch->interpolated(2)};
    compare(kind.gridLight, grid, same(kGridTolerance), "light at texels");
    if (const std::optional<Channels> tolerance = exactTolerance(*patch, hit))
      compare(kind.exactLight, truth_.at(hit), *tolerance, "exact light");
  }

  /// Nothing is interpolated: light at texels and exact light are that of the sprite's point.
  void compareSpriteLight(const View& view, const TruthHit& hit, KindTally& kind, int i, int j) {
    const Sprite& sprite = level_.spriteOf(*hit.sprite);
    const AirPoint place = litPointOf(level_, sprite);
    const Channels expected =
        sprite.isBright ? same(255) : shown(truth_.at(place), level_[sprite.sector].light);
    const auto slack = [&] { return sprite.isBright ? Channels{} : truth_.hairSlack(place); };
    compareLevels(view, i, j, kind.gridLight, expected, same(kGridTolerance), slack,
                  "light of a sprite");
    compareLevels(view, i, j, kind.exactLight, expected, same(kExactTolerance), slack,
                  "exact light of a sprite");
  }

  /// Whether it was excused because the places that are lit are known to a hair only, which may
  /// make a difference of `slack()`.
  template <typename Slack>
  bool compareLevels(const View& view, int i, int j, Count& sort, const Channels& expected,
                     const Channels& tolerance, Slack&& slack, std::string_view what) {
    const Rgb color = view.lit.at(i, j);
    const Channels drawn{1.0 * color.r, 1.0 * color.g, 1.0 * color.b};
    bool byHair = false;
    const auto atEdge = [&] {
      if (!view.truth.isClear(i + 0.5, j + 0.5, kEdgePx)) return true;
      return byHair = areWithin(sum(tolerance, slack()), drawn, expected);
    };
    count(sort, areWithin(tolerance, drawn, expected), atEdge, [&] { noteMiss(view, what, i, j); });
    return byHair;
  }

  /// As a picture shows it with the sector's own light.
  static Channels shown(const Channels& levels, double sectorLight) {
    Channels shown{};
    for (std::size_t channel = 0; channel < 3; ++channel)
      shown[channel] =
          255 * std::min(1.0, std::clamp(levels[channel], 0.0, 255.0) / 255 + sectorLight);
    return shown;
  }

  /// Levels that exact light may miss; counts the pixel as left out where no channel is compared.
  std::optional<Channels> exactTolerance(const PatchLight& patch, const TruthHit& hit) {
    const auto why = whyLeftOut(patch, hit);
    if (std::ranges::all_of(why, [](const auto& reason) { return reason.has_value(); })) {
      ++tally_.leftOut[static_cast<std::size_t>(*std::ranges::min(why))];
      return std::nullopt;
    }
    Channels tolerance{};
    for (std::size_t channel = 0; channel < 3; ++channel)
      tolerance[channel] = why[channel] ? kAny : kExactTolerance;
    return tolerance;
  }

  /// Why exact light is not compared at a pixel, if it is not; of each channel.
  std::array<std::optional<LeftOut>, 3> whyLeftOut(const PatchLight& patch,
                                                   const TruthHit& hit) const {
    if (const auto why = whyAllLeftOut(patch, hit)) return {why, why, why};
    std::array<std::optional<LeftOut>, 3> why;
    const Channels atCurves = truth_.missAtCurves(patch, hit);
    const Channels beyondEdge = truth_.missBeyondEdge(patch);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (atCurves[channel] > kInterpolationAtCurves)
        why[channel] = LeftOut::CurveJump;
      else if (patch.clipsBetween(channel))
        why[channel] = LeftOut::Clip;
      else if (atCurves[channel] + beyondEdge[channel] > kInterpolation)
        why[channel] = LeftOut::BeyondEdge;
    }
    return why;
  }

  std::optional<LeftOut> whyAllLeftOut(const PatchLight& patch, const TruthHit& hit) const {
    if (level_.bake.texel > kFineTexel) return LeftOut::CoarseTexel;
    const double near = level_.bake.lambert ? kNearLightWithCosine : kNearLight;
    for (const LightSource& light : level_.lights)
      if (!light.sun && length(light.position - hit.point) < near) return LeftOut::NearLight;
    if (patch.lacksSamples()) return LeftOut::InsideMesh;
    if (!truth_.seesAlike(patch, hit)) return LeftOut::ShadowEdge;
    return std::nullopt;
  }

  void noteMiss(const View& view, std::string_view what, int i, int j) {
    if (tally_.firstMiss.empty())
      tally_.firstMiss =
          fmt::format("{} at pixel {},{} of shot {} of {}", what, i, j, view.shot.name, name_);
  }

  Level level_;
  Scene scene_;
  const std::vector<Image>& textures_;
  std::string_view name_;
  BakedLight light_;
  Renderer renderer_;
  TexelTruth truth_;
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
