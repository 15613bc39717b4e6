#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "load/load.h"
#include "measure/frame_times.h"
#include "measure/tradeoff/errors.h"
#include "measure/tradeoff/trials.h"
#include "settings/options.h"

namespace hearth {

/// What a trial costs in time (varies from run to run) and in work (does not), and its error.
struct TrialResult {
  Trial trial;
  // Ratios to the first trial, the base: the median over pairs of runs, trial and base measured
  // back to back. Frames are of all shots of the level, on one thread.
  double bakeCost = 1;
  double frameCost = 1;
  // The ratios above times the base's median time over the whole run.
  double bakeSeconds = 0;
  double frameMilliseconds = 0;
  std::int64_t texels = 0;
  std::int64_t rays = 0;
  std::int64_t bytes = 0;  ///< of lightmaps
  double pixels = 0;       ///< that a frame colours, mean over the shots
  Errors errors;
};

/// How trials are measured.
struct TrialSetup {
  ImageSize frameSize{640, 400};                ///< that is timed
  int threads = 1;                              ///< of bakes
  int repeats = 3;                              ///< of bakes, and of frames of each shot
  Clock clock;                                  ///< must advance between two calls
  std::function<void(std::size_t)> onProgress;  ///< called with the number of measured trials
};

/// Measures each trial in turn with the first, the base, so that a machine that slows down slows
/// both alike. Trials with the same bake share its measurement. Neither `trials` nor `truth`, one
/// for each shot of the level, may be empty; `setup` needs all its functions.
std::vector<TrialResult> measureTrials(const LoadedLevel& loaded, std::vector<Trial> trials,
                                       std::span<const TruthPicture> truth,
                                       const TrialSetup& setup);

}  // namespace hearth
