#include "movers/compare_movers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "agreement/compare_level.h"
#include "level/mover.h"
#include "light/bakery.h"
#include "light/blended_light.h"
#include "light/rebake.h"
#include "measure/light_difference.h"
#include "movers/random_movers.h"
#include "random_levels/random.h"
#include "render/renderer.h"

namespace hearth::movers {

namespace {

constexpr double kTexel = 0.5;  // metres: coarse, for the sake of time
constexpr std::size_t kShots = 2;

BakeSettings coarse(BakeSettings settings) {
  settings.texel = kTexel;
  return settings;
}

BakedLight lightOf(const LoadedLevel& loaded) {
  return bake(loaded.scene(), coarse(loaded.level.bake), 1);
}

std::vector<Image> picturesOf(const LoadedLevel& loaded, const BakedLight& light) {
  const Renderer renderer(loaded.scene(), loaded.textures, light);
  std::vector<Image> pictures;
  for (std::size_t i = 0; i < std::min(kShots, loaded.level.shots.size()); ++i)
    for (const LightMode mode : {LightMode::Both, LightMode::Only})
      pictures.push_back(renderer.draw(cameraOf(loaded.level.shots[i]), mode));
  return pictures;
}

bool areSame(const Image& a, const Image& b) {
  return a.width() == b.width() && a.height() == b.height() &&
         std::ranges::equal(a.pixels(), b.pixels());
}

/// The lightmaps of surfaces that show, in the order of the surfaces.
std::vector<const Lightmap*> lightmapsOf(const LoadedLevel& loaded, const BakedLight& light) {
  std::vector<const Lightmap*> maps;
  for (const SurfaceId id : loaded.scene().shownSurfaces()) {
    const auto& map = light.lightmaps[id.index()];
    maps.push_back(map ? &*map : nullptr);
  }
  return maps;
}

bool areSame(const Lightmap* a, const Lightmap* b) {
  if (!a || !b) return a == b;
  return a->rect == b->rect && a->channels == b->channels && a->levels == b->levels;
}

bool haveSameLight(const LoadedLevel& level, const BakedLight& light, const LoadedLevel& other,
                   const BakedLight& otherLight) {
  return std::ranges::equal(lightmapsOf(level, light), lightmapsOf(other, otherLight),
                            [](const auto* a, const auto* b) { return areSame(a, b); });
}

/// Whether as many samples see each light.
bool areSeenAlike(const BakedLight& a, const BakedLight& b) {
  return std::ranges::equal(a.lightCosts, b.lightCosts, {}, &LightCost::seenSamples,
                            &LightCost::seenSamples);
}

/// What follows from heights, things apart.
bool areSame(const LoadedLevel& a, const Geometry& moved) {
  const Scene one = a.scene();
  const Scene other(a.level, moved);
  if (a.geometry.sectors != moved.sectors || a.geometry.segments != moved.segments) return false;
  return std::ranges::all_of(a.level.segments, [&](const Segment& segment) {
    return std::ranges::equal(one.piecesOf(segment), other.piecesOf(segment));
  });
}

/// Of all surfaces that show in one.
bool haveSameGrids(const BakedLight& one, const BakedLight& other) {
  for (std::size_t i = 0; i < one.surfaces.size(); ++i)
    if (one.surfaces[i] && other.surfaces[i] && one.surfaces[i]->grid != other.surfaces[i]->grid)
      return false;
  return true;
}

/// Compares one level.
class Comparison {
 public:
  Comparison(std::uint64_t seed, const std::filesystem::path& folder)
      : seed_(seed),
        random_(seed + 1),
        level_(seed, folder),
        geometry_{},
        memory_(std::size_t{1} << random_.between(8, 22)) {
    memory_.keepBakes(1 + random_.below(8));
  }

  MoverTally run() {
    if (!level_.loaded().result.loaded) return tally_;
    tally_.levels = 1;
    const std::size_t movers = authored().level.movers.size();
    tally_.movers = static_cast<std::int64_t>(movers);
    geometry_ = authored().geometry;
    std::vector<std::size_t> all;
    for (std::size_t ends = 0; ends < std::size_t{1} << movers; ++ends) all.push_back(ends);
    random_.shuffle(all);
    for (const std::size_t ends : all) compareAtEnds(ends, movers);
    compareBetween(movers);
    return tally_;
  }

 private:
  const LoadedLevel& authored() const { return *level_.loaded().result.loaded; }

  void fail(const std::string& what, const std::vector<double>& shares) {
    ++tally_.failed;
    if (tally_.firstFailure.empty())
      tally_.firstFailure = fmt::format("level {} at {}: {}", seed_, fmt::join(shares, ", "), what);
  }

  std::optional<LoadedLevel> loadedAt(const std::vector<double>& shares) {
    LoadResult result = levelAt(authored(), level_.loaded().source, shares);
    if (!result.loaded)
      fail("refused: " + (result.diagnostics.empty() ? "" : format(result.diagnostics.front())),
           shares);
    return std::move(result.loaded);
  }

  /// Moves flats that do not stand where they stand in `to`.
  void move(const Geometry& to) {
    std::vector<MovedFlats> moved;
    for (const Sector& sector : authored().level.sectors) {
      const SectorGeometry heights = to.sectors[sector.id.index()];
      if (geometry_.sectors[sector.id.index()] != heights) moved.push_back({sector.id, heights});
    }
    moveFlats(authored().level, moved, geometry_);
  }

  void compareAtEnds(std::size_t ends, std::size_t movers) {
    ++tally_.states;
    std::vector<double> shares;
    for (std::size_t i = 0; i < movers; ++i) shares.push_back((ends >> i & 1U) != 0 ? 1 : 0);
    const std::optional<LoadedLevel> moved = loadedAt(shares);
    const LoadResult written = level_.loadAuthoredAt(shares);
    if (!written.loaded) return fail("the level authored so is refused", shares);
    if (!moved) return;
    move(moved->geometry);
    if (!areSame(*moved, geometry_)) fail("the geometry differs that was moved there", shares);
    const BakedLight light = lightOf(*moved);
    const BakedLight expected = lightOf(*written.loaded);
    if (!haveSameLight(*moved, light, *written.loaded, expected)) fail("the light differs", shares);
    Rebake rebake(memory_, moved->scene(), coarse(moved->level.bake), 1);
    const BakedLight again = *rebake.finish();
    if (!haveSameLight(*moved, again, *written.loaded, expected))
      fail("the light differs that was found with that of other states", shares);
    if (!areSeenAlike(again, light))
      fail("other samples see light that was found with that of other states", shares);
    const std::vector<Image> pictures = picturesOf(*moved, light);
    tally_.pictures += std::ssize(pictures);
    if (!std::ranges::equal(pictures, picturesOf(*written.loaded, expected),
                            [](const Image& a, const Image& b) { return areSame(a, b); }))
      fail("a picture differs", shares);
  }

  void compareBetween(std::size_t movers) {
    std::vector<double> shares;
    for (std::size_t i = 0; i < movers; ++i) shares.push_back(random_.unit());
    const std::optional<LoadedLevel> moved = loadedAt(shares);
    if (!moved) return;
    ++tally_.between;
    move(moved->geometry);
    if (!areSame(*moved, geometry_)) fail("the geometry differs that was moved there", shares);
    tally_.truth = agreement::compareLevel(*moved, fmt::format("level {}", seed_), kShots);
    if (tally_.truth.missed() > 0 || tally_.truth.holes > 0)
      fail("differs from truth: " + tally_.truth.firstMiss, shares);
    compareLight(*moved, shares);
  }

  void compareLight(const LoadedLevel& moved, const std::vector<double>& shares) {
    const RestStates states(shares);
    std::vector<LoadedLevel> rests;
    std::vector<BakedLight> baked;
    for (std::size_t i = 0; i < states.count(); ++i) {
      auto rest = loadedAt(states.shares(i));
      if (!rest) return;
      baked.push_back(lightOf(*rest));
      rests.push_back(*std::move(rest));
    }
    std::vector<LightAtRest> lights;
    for (std::size_t i = 0; i < states.count(); ++i)
      lights.push_back({rests[i].scene(), &baked[i]});
    const BakedLight blended = blendedLight(moved.scene(), lights, states.weights(), 1);
    compareFrames(moved, lights, states.weights(), blended, shares);
    const LightDifference difference = differenceOf(blended, lightOf(moved));
    tally_.squares += difference.rms * difference.rms * static_cast<double>(difference.texels);
    tally_.lightTexels += difference.texels;
  }

  /// Light that is kept from frame to frame with that of a single picture, and at rest with a bake.
  void compareFrames(const LoadedLevel& moved, const std::vector<LightAtRest>& lights,
                     std::span<const double> weights, const BakedLight& blended,
                     const std::vector<double>& shares) {
    BlendedLight frames;
    for (const LightAtRest& rest : lights) {
      frames.setStates({&rest, 1});
      frames.blend(rest.scene, std::vector{1.0});
      compareDrawn({rest.scene, authored().textures, *rest.light},
                   {rest.scene, authored().textures, frames.light()}, "light at rest", shares);
    }
    frames.setStates(lights);
    frames.blend(moved.scene(), weights);
    // Walls may continue one another on another grid while a door is open: then the light is the
    // same, but not all texels.
    if (haveSameGrids(blended, frames.light()))
      compareDrawn({moved.scene(), moved.textures, blended},
                   {moved.scene(), moved.textures, frames.light()}, "light of frames", shares);
    else
      ++tally_.otherGrids;
  }

  void compareDrawn(const Renderer& a, const Renderer& b, const char* what,
                    const std::vector<double>& shares) {
    const std::vector<Shot>& shots = authored().level.shots;
    for (std::size_t i = 0; i < std::min(kShots, shots.size()); ++i)
      if (!areSame(a.draw(cameraOf(shots[i]), LightMode::Only),
                   b.draw(cameraOf(shots[i]), LightMode::Only)))
        fail(fmt::format("{}, shot {}", what, i), shares);
  }

  std::uint64_t seed_;
  random_levels::Random random_;
  RandomMovers level_;
  Geometry geometry_;   ///< of the authored level, moved from state to state
  LightMemory memory_;  ///< of little room or much, for one state or several
  MoverTally tally_;
};

}  // namespace

MoverTally& MoverTally::operator+=(const MoverTally& other) {
  levels += other.levels;
  movers += other.movers;
  states += other.states;
  pictures += other.pictures;
  between += other.between;
  truth += other.truth;
  squares += other.squares;
  lightTexels += other.lightTexels;
  otherGrids += other.otherGrids;
  failed += other.failed;
  if (firstFailure.empty()) firstFailure = other.firstFailure;
  return *this;
}

MoverTally compareRandomMovers(std::uint64_t seed, const std::filesystem::path& folder) {
  return Comparison(seed, folder).run();
}

std::string inWords(const MoverTally& tally) {
  const double rms = tally.lightTexels == 0
                         ? 0
                         : std::sqrt(tally.squares / static_cast<double>(tally.lightTexels));
  return fmt::format(
      "{} levels with {} movers: {} states at rest and {} pictures of them compared with levels\n"
      "  authored so; {} states between: {} pixels compared with truth, {} holes, {} differ;\n"
      "  light there {:.2f} levels RMS from a bake at these heights, over {} texels;\n"
      "  light of frames is that of single pictures in all but {} levels; {} failed\n",
      tally.levels, tally.movers, tally.states, tally.pictures, tally.between,
      tally.truth.sum().texture.tested, tally.truth.holes, tally.truth.missed(), rms,
      tally.lightTexels, tally.otherGrids, tally.failed);
}

}  // namespace hearth::movers
