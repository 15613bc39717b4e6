#include "hearth/tradeoff/measure_trials.h"

#include <algorithm>
#include <map>

#include "render/renderer.h"

namespace hearth {

namespace {

/// Trials of one bake.
class BakeTrials {
 public:
  BakeTrials(const LoadedLevel& loaded, const BakeSettings& settings, const TrialBench& bench)
      : loaded_(loaded), bench_(bench) {
    const double begin = bench_.clock();
    light_ = bake(loaded_.level, settings, bench_.threads);
    seconds_ = bench_.clock() - begin;
  }

  /// Frames of all trials in turn, so that what else the machine does strikes all alike.
  void measure(std::span<Measured*> trials, std::span<const TruthPicture> truth) {
    std::vector<Renderer> renderers;
    for (const Measured* trial : trials)
      renderers.emplace_back(loaded_.level, loaded_.textures, light_, trial->trial.draw);
    std::vector<std::vector<double>> times(trials.size());
    for (int repeat = 0; repeat < bench_.repeats; ++repeat)
      for (const TruthPicture& of : truth)
        for (std::size_t k = 0; k < trials.size(); ++k)
          times[k].push_back(frameMilliseconds(renderers[k], of.camera, *trials[k]));
    for (std::size_t k = 0; k < trials.size(); ++k) {
      Measured& trial = *trials[k];
      trial.frameMilliseconds = spreadOf(times[k]).median;
      trial.bakeSeconds = seconds_;
      trial.texels = light_.stats.texels;
      trial.rays = light_.stats.rays;
      trial.bytes = light_.stats.bytes;
      trial.pixels /= static_cast<double>(times[k].size());
      trial.lightLookups /= static_cast<double>(times[k].size());
      trial.errors = errorsOf(renderers[k], truth);
    }
  }

 private:
  /// Draws the frame twice: what the first of them waits for, memory and caches, is no work of the
  /// settings.
  double frameMilliseconds(const Renderer& renderer, Camera camera, Measured& trial) {
    camera.width = bench_.frameSize.width;
    camera.height = bench_.frameSize.height;
    renderer.draw(camera, LightMode::Both, scratch_, picture_);
    const double begin = bench_.clock();
    renderer.draw(camera, LightMode::Both, scratch_, picture_);
    const double seconds = bench_.clock() - begin;
    trial.pixels += static_cast<double>(scratch_.painted.pixels);
    trial.lightLookups += static_cast<double>(scratch_.painted.lightLookups);
    return 1e3 * seconds;
  }

  static Errors errorsOf(const Renderer& renderer, std::span<const TruthPicture> truth) {
    ErrorSums sums;
    for (const TruthPicture& of : truth)
      sums.add(of, renderer.draw(of.camera, LightMode::Both),
               renderer.draw(of.camera, LightMode::Only));
    return sums.errors();
  }

  const LoadedLevel& loaded_;
  const TrialBench& bench_;
  BakedLight light_;
  double seconds_ = 0;
  FrameScratch scratch_;
  Image picture_;
};

/// Those that have the bake of the first of them.
std::vector<Measured*> withSameBake(std::span<Measured> trials, const BakeSettings& bake) {
  std::vector<Measured*> same;
  for (Measured& trial : trials)
    if (trial.trial.bake == bake) same.push_back(&trial);
  return same;
}

}  // namespace

std::vector<Measured> measureTrials(const LoadedLevel& loaded, std::vector<Trial> trials,
                                    std::span<const TruthPicture> truth, const TrialBench& bench) {
  std::vector<Measured> measured;
  for (Trial& trial : trials) measured.emplace_back().trial = std::move(trial);
  std::vector<BakeSettings> bakes;
  std::size_t count = 0;
  for (const Measured& trial : measured) {
    const BakeSettings& settings = trial.trial.bake;
    if (std::ranges::find(bakes, settings) != bakes.end()) continue;
    bakes.push_back(settings);
    std::vector<Measured*> same = withSameBake(measured, settings);
    BakeTrials(loaded, settings, bench).measure(same, truth);
    bench.done(count += same.size());
  }
  return measured;
}

}  // namespace hearth
