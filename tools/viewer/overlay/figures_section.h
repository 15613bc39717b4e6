#pragma once

#include <cstdint>
#include <optional>

#include "render/frame_stats.h"
#include "text/progress_text.h"
#include "viewer/overlay/frame_history.h"

namespace hearth {

/// What a walk costs.
struct Figures {
  FrameHistory frames;
  FrameCounters counters = countersOf({}, {});  ///< of the last frame
  std::optional<StageProgress> bake;            ///< while there is one that shows
  std::int64_t lightmapBytes = 0;
  double residentBytes = 0;  ///< what the program holds of the machine's memory
};

/// What the graph's height stands for where frames took up to `longest`, both in seconds: 1, 2 or 5
/// times a power of ten of milliseconds, at least 1.
double scaleFor(double longest);

/// A section of the overlay.
void showFigures(const Figures& figures);

}  // namespace hearth
