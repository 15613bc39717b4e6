#pragma once

#include <string>

#include "measure/level_bench.h"
#include "render/renderer.h"

/// Settings that fit a time, by the measurements of `hearth tradeoff`.
namespace hearth {

struct FittingBake {
  BakeSettings settings;
  double seconds = 0;  ///< that it will take, roughly
  double rms = 0;      ///< expected error of light, in levels
};

/// Bakes coarsely to measure this level on this machine; that time is part of `seconds`.
FittingBake bakeFitting(const Scene& scene, const BakeSettings& authored, double seconds,
                        int threads, const Clock& clock);

struct FittingFrame {
  DrawSettings draw;
  double milliseconds = 0;  ///< that it will take, roughly
  double over2 = 0;         ///< expected fraction of pixels that are off by more than 2 levels
};

/// Draws what the camera sees a few times. `renderer` draws exactly.
FittingFrame frameFitting(const Renderer& renderer, const Camera& camera, double milliseconds,
                          Workers* workers, const Clock& clock);

/// The chosen settings and their expected cost and error, in one line.
std::string words(const FittingBake& fitting);
std::string words(const FittingFrame& fitting);

}  // namespace hearth
