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
  // Times as multiples of the base trial's, the first: medians over pairs that are measured back to
  // back. Frames are of all shots of the level, on one thread.
  double bakeCost = 1;
  double frameCost = 1;
  // These multiplied by the median time of the base over the whole run.
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
  ImageSize frameSize{640, 400};                ///< that is timed
  int threads = 1;                              ///< of bakes
  int repeats = 3;                              ///< of bakes, and of frames of each shot
  Clock clock;                                  ///< must advance between two calls
  std::function<void(std::size_t)> onProgress;  ///< called with the number of measured trials
};

/// Measures each trial in turn with the first, the base, so that a machine that slows down slows
/// both alike. Trials with the same bake share its measurement. Neither `trials` nor `truth`, one
/// for each shot of the level, may be empty; `bench` needs all its functions.
std::vector<Measured> measureTrials(const LoadedLevel& loaded, std::vector<Trial> trials,
                                    std::span<const TruthPicture> truth, const TrialBench& bench);

}  // namespace hearth
