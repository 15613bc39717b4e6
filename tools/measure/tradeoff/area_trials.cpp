#include "measure/tradeoff/area_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "light/bakery.h"
#include "math/parallel.h"
#include "math/spread.h"
#include "measure/light_places.h"
#include "measure/tradeoff/cost.h"
#include "truth/truth_gather.h"
#include "truth/truth_light.h"

namespace hearth {

namespace {

constexpr int kChannels = 3;

/// Texels of a level, with the light of areas there.
class AreaTruth {
 public:
  AreaTruth(const Level& level, const Scene& scene, const BakedLight& whole,
            const BakedLight& direct, const AreaTrialSetup& setup)
      : direct_(direct),
        places_(LightPlaces(scene, whole).some(setup.places, [&](const LightPlace& place) {
          return isKnown(whole, place);
        })) {
    constexpr TruthGather::Effort kEffort{.side = 16, .rounds = 4, .seed = 1};
    const TruthLight lights(level);
    const TruthGather gather(level, lights);
    truth_.resize(places_.size());
    parallelFor(places_.size(), setup.threads, [&](std::size_t i) {
      const Vec3 levels = gather.at(places_[i].point, kEffort).light.sum();
      truth_[i] = {levels.x, levels.y, levels.z};
    });
  }

  /// Adds how far off a bake is.
  void compare(const BakedLight& baked, AreaTrial& trial) const {
    double squares = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!isKnown(baked, places_[i])) continue;
      double farthest = 0;
      for (int channel = 0; channel < kChannels; ++channel) {
        const double ofAreas =
            levelOf(baked, places_[i], channel) - levelOf(direct_, places_[i], channel);
        farthest =
            std::max(farthest, std::abs(ofAreas - truth_[i][static_cast<std::size_t>(channel)]));
      }
      ++trial.places;
      squares += farthest * farthest;
      trial.most = std::max(trial.most, farthest);
      if (farthest > AreaTrial::kVisible) ++trial.far;
    }
    if (trial.places > 0) trial.rms = std::sqrt(squares / static_cast<double>(trial.places));
  }

 private:
  static int levelOf(const BakedLight& baked, const LightPlace& place, int channel) {
    const std::optional<Lightmap>& map = baked.lightmaps[place.map.index()];
    return map ? map->at(place.i, place.j, channel) : 0;
  }

  /// Not so where light is as bright as can be.
  static bool isKnown(const BakedLight& baked, const LightPlace& place) {
    const auto isBrightest = [&](int channel) { return levelOf(baked, place, channel) == 255; };
    return !isBrightest(0) && !isBrightest(1) && !isBrightest(2);
  }

  const BakedLight& direct_;
  std::vector<LightPlace> places_;
  std::vector<std::array<double, kChannels>> truth_;  ///< levels at each place
};

/// With a sample in the middle of each texel, where truth is asked, and lit by points, which truth
/// finds fast.
Level asPoints(Level level, const BakeSettings& settings) {
  level.bake = settings;
  level.bake.samples = 1;
  for (LightSource& light : level.lights) light.radius = 0;
  return level;
}

BakeSettings with(const AreaSetting& setting, BakeSettings settings) {
  if (setting.of == AreaSetting::Of::Bounces)
    settings.bounces = static_cast<int>(setting.value);
  else
    settings.gatherError = setting.value;
  return settings;
}

std::int64_t slicesOf(const Level& level, const BakedLight& baked) {
  std::int64_t slices = 0;
  for (std::size_t i = 0; i < baked.lightCosts.size(); ++i)
    if (i >= level.lights.size() || level.lights[i].isArea()) slices += baked.lightCosts[i].rays;
  return slices;
}

}  // namespace

bool takeOutAreas(Level& level) {
  const bool didBounce = std::exchange(level.bake.bounces, 0) > 0;
  const auto isArea = [](const LightSource& light) { return light.isArea(); };
  return std::erase_if(level.lights, isArea) > 0 || didBounce;
}

std::vector<AreaTrial> measureAreas(const LoadedLevel& loaded, const BakeSettings& settings,
                                    std::span<const AreaSetting> tried,
                                    const AreaTrialSetup& setup) {
  const Level level = asPoints(loaded.level, settings);
  const Scene scene(level, loaded.geometry);
  Level others = level;
  takeOutAreas(others);
  const BakedLight direct = bake(Scene(others, loaded.geometry), others.bake, setup.threads);
  const BakedLight whole = bake(scene, level.bake, setup.threads);
  const AreaTruth truth(level, scene, whole, direct, setup);

  std::vector<AreaTrial> trials;
  std::vector<double> ownSeconds;
  for (const AreaSetting& setting : tried) {
    AreaTrial trial{.setting = setting};
    const BakeSettings its = with(setting, level.bake);
    BakedLight own;
    BakedLight baked;
    const auto secondsOf = [&](const BakeSettings& of, BakedLight& light) {
      const double begin = setup.clock();
      light = bake(scene, of, setup.threads);
      return setup.clock() - begin;
    };
    const TurnTimes times = timedInTurn([&] { return secondsOf(level.bake, own); },
                                        [&] { return secondsOf(its, baked); }, setup.repeats);
    trial.cost = costOf(ratiosOf(times));
    ownSeconds.insert(ownSeconds.end(), times.bases.begin(), times.bases.end());
    trial.slices = slicesOf(level, baked);
    truth.compare(baked, trial);
    trials.push_back(trial);
    setup.onProgress(trials.size());
  }
  for (AreaTrial& trial : trials) trial.seconds = trial.cost * spreadOf(ownSeconds).median;
  return trials;
}

std::string nameOf(const AreaTrial& trial) {
  const auto& [of, value] = trial.setting;
  return fmt::format("{} {}", of == AreaSetting::Of::Bounces ? "--bounces" : "--gather-error",
                     value);
}

double farShareOf(const AreaTrial& trial) {
  return static_cast<double>(trial.far) /
         static_cast<double>(std::max<std::size_t>(1, trial.places));
}

std::string tableOf(const std::vector<AreaTrial>& trials) {
  std::string text = fmt::format("{:<20} {:>8} {:>8} {:>12} {:>7} {:>6} {:>6} {:>6}\n", "settings",
                                 "bake x", "bake s", "slices", "places", "RMS", "max", "> 4 %");
  for (const AreaTrial& of : trials)
    text += fmt::format("{:<20} {:>8.2f} {:>8.3f} {:>12} {:>7} {:>6.2f} {:>6.1f} {:>6.2f}\n",
                        nameOf(of), of.cost, of.seconds, of.slices, of.places, of.rms, of.most,
                        100 * farShareOf(of));
  return text;
}

std::string csvOf(const std::vector<AreaTrial>& trials) {
  std::string text = "settings,bake_cost,bake_seconds,slices,places,light_rms,light_max,over4\r\n";
  for (const AreaTrial& of : trials)
    text += fmt::format("{},{},{},{},{},{},{},{}\r\n", nameOf(of), of.cost, of.seconds, of.slices,
                        of.places, of.rms, of.most, of.far);
  return text;
}

}  // namespace hearth
