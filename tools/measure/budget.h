#pragma once

#include <string>

#include "measure/level_bench.h"
#include "render/renderer.h"

/// Settings that fit a time, by what `hearth tradeoff` has measured.
namespace hearth {

struct FittingBake {
  BakeSettings settings;
  double seconds = 0;  ///< that it will take, about
  double rms = 0;      ///< about so many levels light will be off
};

/// Bakes coarsely, to see how long this level takes here; what that takes is part of `seconds`.
FittingBake bakeFitting(const Scene& scene, const BakeSettings& ofLevel, double seconds,
                        int threads, const Clock& clock);

struct FittingFrame {
  DrawSettings draw;
  double milliseconds = 0;  ///< that it will take, about
  double over2 = 0;         ///< about such a fraction of pixels will be off by more than 2 levels
};

/// Draws what the camera sees a few times. `renderer` draws exactly.
FittingFrame frameFitting(const Renderer& renderer, const Camera& camera, double milliseconds,
                          Workers* workers, const Clock& clock);

/// What was picked and what is expected of it, in one line.
std::string words(const FittingBake& fitting);
std::string words(const FittingFrame& fitting);

}  // namespace hearth
