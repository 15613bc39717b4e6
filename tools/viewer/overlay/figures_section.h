#pragma once

#include <cstdint>
#include <optional>

#include "render/frame_stats.h"
#include "text/progress_text.h"
#include "viewer/overlay/frame_history.h"

namespace hearth {

/// The costs of a walk.
struct Figures {
  FrameHistory frames;
  FrameCounters counters = countersOf({}, {});  ///< of the last frame
  std::optional<StageProgress> bake;            ///< while there is one that shows
  std::int64_t lightmapBytes = 0;
  double residentBytes = 0;  ///< memory of the machine that the program holds
};

/// The time that the graph's height stands for if frames take up to `longest`, both in seconds: 1,
/// 2 or 5 times a power of ten of milliseconds, at least 1.
double scaleFor(double longest);

/// A section of the overlay.
void showFigures(const Figures& figures);

}  // namespace hearth
