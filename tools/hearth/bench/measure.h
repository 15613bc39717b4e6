#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "hearth/options.h"
#include "light/bakery.h"
#include "load/load.h"
#include "render/draw_settings.h"

namespace hearth {

struct Spread {
  double median = 0;
  double p95 = 0;  ///< which 95 of 100 do not exceed
};

/// Of at least one value.
Spread spreadOf(std::vector<double> values);

/// Of the work of a frame, mean over the shots, which neither size of machine nor chance changes.
struct FrameCounter {
  std::string_view name;  ///< stable: scripts read it
  double mean = 0;
};
using FrameCounters = std::array<FrameCounter, 14>;

/// Frames of one size, of all shots of a level.
struct FrameBench {
  PictureSize size;
  int threads = 1;
  Spread milliseconds;  ///< a frame
  /// One plain write of four bytes for each of its pixels, after each frame: what memory asks of
  /// whoever draws.
  Spread writeMilliseconds;
  FrameCounters counters;
};

struct BakeBench {
  int threads = 1;
  Spread seconds;
};

/// What drawing and baking a level costs here.
struct BenchReport {
  int repeats = 0;
  BakeSettings settings;
  DrawSettings drawSettings;
  std::vector<FrameBench> frames;
  std::vector<BakeBench> bakes;
  BakeStats bake;
  std::int64_t texelLightTests = 0;  ///< samples, each with every light that its surface faces
};

/// In seconds, from any beginning.
using Clock = std::function<double()>;
/// One that nobody sets.
double steadySeconds();

/// Draws every shot of the level in three sizes, and bakes, each `repeats` times on one thread and
/// on `threads`: everything once, then everything again, so that what else the machine does
/// strikes all alike; after each frame memory of its size is written. A level without shots is
/// drawn as its player sees it. Memory that frames are drawn in has grown before the first is
/// counted.
BenchReport measure(const LoadedLevel& loaded, const BakeSettings& settings,
                    const DrawSettings& drawSettings, int threads, int repeats, const Clock& clock);

}  // namespace hearth
