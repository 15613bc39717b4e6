#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "measure/level_bench.h"
#include "measure/tradeoff/errors.h"
#include "measure/tradeoff/trials.h"

namespace hearth {

/// The cost of a trial in time, which differs from run to run, and in work, which does not; and its
/// error.
struct Measured {
  Trial trial;
  // Medians of ratios to the first trial, the base, each within a moment; of the base 1. A frame's
  // are of the level's shots, on one thread.
  double bakeCost = 1;
  double frameCost = 1;
  // The same times what the base took in the whole run, as a median.
  double bakeSeconds = 0;
  double frameMilliseconds = 0;
  std::int64_t texels = 0;
  std::int64_t rays = 0;
  std::int64_t bytes = 0;  ///< of lightmaps
  double pixels = 0;       ///< that a frame colours, mean over the shots
  Errors errors;
};

/// How trials are measured.
struct TrialBench {
  ImageSize frameSize{640, 400};          ///< that is timed
  int threads = 1;                        ///< of bakes
  int repeats = 3;                        ///< of bakes, and of frames of each shot
  Clock clock;                            ///< never stands still
  std::function<void(std::size_t)> done;  ///< called with the number of trials that are measured
};

/// Measures each trial in turn with the first, the base, because a machine under load gets slower.
/// Trials with the same bake share its measurement. `truth` is of the level's shots; none may
/// be empty.
std::vector<Measured> measureTrials(const LoadedLevel& loaded, std::vector<Trial> trials,
                                    std::span<const TruthPicture> truth, const TrialBench& bench);

}  // namespace hearth
