#include "measure/tradeoff/measure_trials.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "light/bakery.h"
#include "math/spread.h"
#include "measure/tradeoff/cost.h"
#include "render/renderer.h"

namespace hearth {

namespace {

/// Bakes a level and draws its shots, by a clock.
class Stopwatch {
 public:
  Stopwatch(const LoadedLevel& loaded, std::span<const TruthPicture> truth, const TrialSetup& setup)
      : loaded_(loaded), setup_(setup) {
    for (const TruthPicture& of : truth) {
      Camera camera = of.camera;
      camera.width = setup.frameSize.width;
      camera.height = setup.frameSize.height;
      cameras_.push_back(camera);
    }
  }

  std::span<const Camera> cameras() const { return cameras_; }

  double secondsToBake(const BakeSettings& settings, BakedLight& light) const {
    light = {};
    const double begin = setup_.clock();
    light = bake(loaded_.scene(), settings, setup_.threads);
    return setup_.clock() - begin;
  }

  /// Draws the frame twice: what the first of them waits for, memory and caches, is no work of the
  /// settings.
  double secondsToDraw(const Renderer& renderer, const Camera& camera) {
    draw(renderer, camera);
    const double begin = setup_.clock();
    draw(renderer, camera);
    return setup_.clock() - begin;
  }

  const PaintStats& draw(const Renderer& renderer, const Camera& camera) {
    renderer.draw(camera, LightMode::Both, scratch_, memory_.rows(camera.width, camera.height));
    return scratch_.painted;
  }

 private:
  const LoadedLevel& loaded_;
  const TrialSetup& setup_;
  std::vector<Camera> cameras_;
  FrameScratch scratch_;
  PixelBuffer memory_;
};

/// Trials, each compared with the base.
class Measurement {
 public:
  Measurement(const LoadedLevel& loaded, const Trial& base, std::span<const TruthPicture> truth,
              const TrialSetup& setup)
      : loaded_(loaded),
        base_(base),
        truth_(truth),
        setup_(setup),
        watch_(loaded, truth, setup),
        bakeSeconds_{watch_.secondsToBake(base.bake, light_)},
        renderer_(loaded.scene(), loaded.textures, light_, base.draw) {
    for (const Camera& camera : watch_.cameras()) drawBase(camera);
  }

  /// Trials of one bake.
  void measure(std::span<TrialResult*> trials) {
    const BakeSettings& settings = trials.front()->trial.bake;
    BakedLight baked;
    const bool isBaseBake = settings == base_.bake;
    const double bakeCost = isBaseBake ? 1 : costOfBake(settings, baked);
    const BakedLight& light = isBaseBake ? light_ : baked;
    for (TrialResult* result : trials) {
      result->bakeCost = bakeCost;
      result->texels = light.stats.texels;
      result->rays = light.stats.rays;
      result->bytes = light.stats.bytes;
      const Renderer renderer(loaded_.scene(), loaded_.textures, light, result->trial.draw);
      if (!isBaseBake || result->trial.draw != base_.draw)
        result->frameCost = costOfFrame(renderer);
      countWork(renderer, *result);
      result->errors = errorsOf(renderer);
    }
  }

  /// Of all trials, in seconds, once the base was timed beside each.
  void giveSeconds(std::span<TrialResult> trials) const {
    for (TrialResult& result : trials) {
      result.bakeSeconds = result.bakeCost * spreadOf(bakeSeconds_).median;
      result.frameMilliseconds = result.frameCost * 1e3 * spreadOf(frameSeconds_).median;
    }
  }

 private:
  double bakeBase() {
    BakedLight again;
    return bakeSeconds_.emplace_back(watch_.secondsToBake(base_.bake, again));
  }
  double drawBase(const Camera& camera) {
    return frameSeconds_.emplace_back(watch_.secondsToDraw(renderer_, camera));
  }

  double costOfBake(const BakeSettings& settings, BakedLight& light) {
    const TurnTimes times =
        timedInTurn([&] { return bakeBase(); },
                    [&] { return watch_.secondsToBake(settings, light); }, setup_.repeats);
    return costOf(ratiosOf(times));
  }

  double costOfFrame(const Renderer& renderer) {
    std::vector<double> ratios;
    for (const Camera& camera : watch_.cameras()) {
      const TurnTimes times =
          timedInTurn([&] { return drawBase(camera); },
                      [&] { return watch_.secondsToDraw(renderer, camera); }, setup_.repeats);
      std::ranges::copy(ratiosOf(times), std::back_inserter(ratios));
    }
    return costOf(std::move(ratios));
  }

  void countWork(const Renderer& renderer, TrialResult& result) {
    PaintStats sum;
    for (const Camera& camera : watch_.cameras()) sum += watch_.draw(renderer, camera);
    const auto frames = static_cast<double>(watch_.cameras().size());
    result.pixels = static_cast<double>(sum.pixels) / frames;
  }

  Errors errorsOf(const Renderer& renderer) const {
    ErrorSums sums;
    for (const TruthPicture& of : truth_)
      sums.add(of, renderer.draw(of.camera, LightMode::Both),
               renderer.draw(of.camera, LightMode::Only));
    return sums.errors();
  }

  const LoadedLevel& loaded_;
  const Trial& base_;
  std::span<const TruthPicture> truth_;
  const TrialSetup& setup_;
  Stopwatch watch_;
  BakedLight light_;                  ///< of the base
  std::vector<double> bakeSeconds_;   ///< ... each time that it was baked
  std::vector<double> frameSeconds_;  ///< ... and drawn
  Renderer renderer_;
};

/// Those that have the same bake.
std::vector<TrialResult*> withBake(std::span<TrialResult> trials, const BakeSettings& bake) {
  std::vector<TrialResult*> same;
  for (TrialResult& result : trials)
    if (result.trial.bake == bake) same.push_back(&result);
  return same;
}

}  // namespace

std::vector<TrialResult> measureTrials(const LoadedLevel& loaded, std::vector<Trial> trials,
                                       std::span<const TruthPicture> truth,
                                       const TrialSetup& setup) {
  std::vector<TrialResult> measured;
  for (Trial& trial : trials) measured.emplace_back().trial = std::move(trial);
  Measurement measurement(loaded, measured.front().trial, truth, setup);
  std::vector<BakeSettings> bakes;
  std::size_t count = 0;
  for (const TrialResult& result : measured) {
    const BakeSettings& settings = result.trial.bake;
    if (std::ranges::find(bakes, settings) != bakes.end()) continue;
    bakes.push_back(settings);
    std::vector<TrialResult*> same = withBake(measured, settings);
    measurement.measure(same);
    setup.onProgress(count += same.size());
  }
  measurement.giveSeconds(measured);
  return measured;
}

}  // namespace hearth
