#include "measure/tradeoff/mover_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "level/mover.h"
#include "light/blended_light.h"
#include "light/rebake.h"
#include "measure/tradeoff/cost.h"

namespace hearth {

namespace {

using Shares = std::vector<double>;

/// A level with its movers somewhere, and its light.
struct LitState {
  LoadedLevel level;
  BakedLight light;
};

/// Of several, all their texels together.
LightDifference pooled(const LightDifference& a, const LightDifference& b) {
  LightDifference sum{a.texels + b.texels, a.visible + b.visible, 0, std::max(a.most, b.most)};
  const double squares =
      a.rms * a.rms * static_cast<double>(a.texels) + b.rms * b.rms * static_cast<double>(b.texels);
  if (sum.texels > 0) sum.rms = std::sqrt(squares / static_cast<double>(sum.texels));
  return sum;
}

/// One mover, the others as authored.
class MoverMeasurement {
 public:
  MoverMeasurement(const LoadedLevel& authored, const LevelSource& source,
                   const BakeSettings& settings, const MoverTrialSetup& setup, std::size_t mover)
      : authored_(authored), source_(source), settings_(settings), setup_(setup), mover_(mover) {
    memory_.keepBakes(kStatesAtOnce);
  }

  /// Loads and bakes each state once. Returns why one cannot be loaded.
  std::optional<std::string> light(const Shares& shares) {
    if (states_.contains(shares)) return std::nullopt;
    LoadResult moved = levelAt(authored_, source_, shares);
    if (!moved.loaded) {
      const auto error = std::ranges::find(moved.diagnostics, true, &Diagnostic::isError);
      return format(*error);
    }
    BakedLight baked = *Rebake(memory_, moved.loaded->scene(), settings_, setup_.threads).finish();
    states_.emplace(shares, LitState{*std::move(moved.loaded), std::move(baked)});
    return std::nullopt;
  }

  /// The shares of all movers in the states at rest on the mover's way, that of the level as
  /// authored apart.
  std::vector<Shares> way(int stages) const {
    std::vector<Shares> way;
    for (int stage = 1; stage <= stages + 1; ++stage) way.push_back(at(1.0 * stage / (stages + 1)));
    return way;
  }

  std::vector<Shares> places() const {
    std::vector<Shares> places;
    for (int i = 0; i < kMoverPlaces; ++i) places.push_back(at((i + 0.5) / kMoverPlaces));
    return places;
  }

  Shares at(double share) const {
    Shares shares(authored_.level.movers.size());
    shares[mover_] = share;
    return shares;
  }

  /// Seconds to bake these, with all that the level as authored tells of their light.
  double secondsToBake(const std::vector<Shares>& way) const {
    LightMemory memory;
    memory.keepBakes(kStatesAtOnce);
    Rebake(memory, authored_.scene(), settings_, setup_.threads).finish();
    const double begin = setup_.clock();
    for (const Shares& shares : way)
      Rebake(memory, states_.at(shares).level.scene(), settings_, setup_.threads).finish();
    return setup_.clock() - begin;
  }

  LightDifference difference(const Shares& shares, int stages) const {
    const LitState& exact = states_.at(shares);
    const RestStates rests(shares, stages);
    std::vector<LightAtRest> lights;
    for (std::size_t i = 0; i < rests.count(); ++i) {
      const LitState& rest = states_.at(rests.shares(i));
      lights.push_back({{authored_.level, rest.level.geometry}, &rest.light});
    }
    return differenceOf(blendedLight(exact.level.scene(), lights, rests.weights(), setup_.threads),
                        exact.light);
  }

 private:
  static constexpr std::size_t kStatesAtOnce = 64;

  const LoadedLevel& authored_;
  const LevelSource& source_;
  const BakeSettings& settings_;
  const MoverTrialSetup& setup_;
  std::size_t mover_;
  LightMemory memory_;
  std::map<Shares, LitState> states_;
};

/// Adds what one mover's way costs, and how far off light on it is. Returns why it cannot be
/// loaded.
std::optional<std::string> addMover(MoverMeasurement& measurement, const MoverTrialSetup& setup,
                                    std::vector<MoverTrial>& trials) {
  const std::vector<Shares> places = measurement.places();
  std::vector<Shares> needed{measurement.at(0)};
  needed.insert(needed.end(), places.begin(), places.end());
  for (const MoverTrial& trial : trials)
    for (Shares& shares : measurement.way(trial.stages)) needed.push_back(std::move(shares));
  for (const Shares& shares : needed)
    if (auto mistake = measurement.light(shares)) return mistake;

  const auto base = [&] { return measurement.secondsToBake(measurement.way(0)); };
  const double baseSeconds = base();
  for (MoverTrial& trial : trials) {
    const std::vector<Shares> way = measurement.way(trial.stages);
    trial.bakes += way.size();
    const auto bakes = [&] { return measurement.secondsToBake(way); };
    const double cost =
        trial.stages == 0 ? 1 : costOf(ratiosOf(timedInTurn(base, bakes, setup.repeats)));
    trial.seconds += cost * baseSeconds;
    for (const Shares& shares : places)
      trial.light = pooled(trial.light, measurement.difference(shares, trial.stages));
  }
  return std::nullopt;
}

}  // namespace

tl::expected<std::vector<MoverTrial>, std::string> measureMovers(const LoadedLevel& authored,
                                                                 const LevelSource& source,
                                                                 const BakeSettings& settings,
                                                                 const std::vector<int>& stages,
                                                                 const MoverTrialSetup& setup) {
  std::vector<MoverTrial> trials(stages.size());
  for (std::size_t i = 0; i < stages.size(); ++i) trials[i].stages = stages[i];
  for (std::size_t mover = 0; mover < authored.level.movers.size(); ++mover) {
    MoverMeasurement measurement(authored, source, settings, setup, mover);
    if (auto mistake = addMover(measurement, setup, trials)) return tl::unexpected(*mistake);
  }
  for (MoverTrial& trial : trials) trial.cost = trial.seconds / trials.front().seconds;
  return trials;
}

std::string tableOf(const std::vector<MoverTrial>& trials) {
  std::string text = fmt::format("{:<18} {:>6} {:>8} {:>8} {:>6} {:>6} {:>6}\n", "settings",
                                 "bakes", "bake x", "bake s", "RMS", "max", "> 4 %");
  for (const MoverTrial& of : trials)
    text += fmt::format("--mover-stages {:<3} {:>6} {:>8.2f} {:>8.3f} {:>6.2f} {:>6} {:>6.2f}\n",
                        of.stages, of.bakes, of.cost, of.seconds, of.light.rms, of.light.most,
                        100.0 * static_cast<double>(of.light.visible) /
                            static_cast<double>(std::max<std::int64_t>(1, of.light.texels)));
  return text;
}

std::string csvOf(const std::vector<MoverTrial>& trials) {
  std::string text = "settings,bakes,bake_cost,bake_seconds,light_rms,light_max,texels,over4\r\n";
  for (const MoverTrial& of : trials)
    text += fmt::format("--mover-stages {},{},{},{},{},{},{},{}\r\n", of.stages, of.bakes, of.cost,
                        of.seconds, of.light.rms, of.light.most, of.light.texels, of.light.visible);
  return text;
}

}  // namespace hearth
