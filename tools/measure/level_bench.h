#pragma once

#include <cstdint>
#include <vector>

#include "light/bakery.h"
#include "load/load.h"
#include "measure/frame_times.h"
#include "render/draw_settings.h"

namespace hearth {

struct BakeBench {
  int threads = 1;
  Spread seconds;
};

/// The cost of drawing and baking a level on this machine.
struct BenchReport {
  int repeats = 0;
  BakeSettings settings;
  DrawSettings drawSettings;
  std::vector<FrameBench> frames;
  std::vector<BakeBench> bakes;
  BakeStats bake;
  std::int64_t texelLightTests = 0;  ///< samples, each with every light that its surface faces
};

/// Draws every shot of the level in three sizes, and bakes, each `repeats` times on one thread and
/// on `threads`: everything once, then everything again, so that other load on the machine
/// affects all alike. After each frame, memory of its size is written. A level without shots is
/// drawn as its player sees it. Memory that frames are drawn in has grown before the first is
/// counted.
BenchReport measure(const LoadedLevel& loaded, const BakeSettings& settings,
                    const DrawSettings& drawSettings, int threads, int repeats, const Clock& clock);

}  // namespace hearth
