#include "render/frame_stats.h"

namespace hearth {

FrameCounters countersOf(const FrameStats& found, const PaintStats& painted) {
  const auto mean = [](auto count) { return static_cast<double>(count); };
  return {{{"viewports", mean(found.viewports)},
           {"flatPortals", mean(found.flatPortals)},
           {"windows", mean(found.windows)},
           {"segments", mean(found.segments)},
           {"sprites", mean(found.sprites)},
           {"faces", mean(found.faces)},
           {"wallColumns", mean(found.wallColumns)},
           {"stackColumns", mean(found.stackColumns)},
           {"slopeColumns", mean(found.slopeColumns)},
           {"spans", mean(found.spans)},
           {"slopeSpans", mean(painted.slopeSpans)},
           {"lightmapSpans", mean(painted.lightmapSpans)},
           {"coloredSpans", mean(painted.coloredSpans)},
           {"lightmapPixels", mean(painted.lightmapPixels)},
           {"pixels", mean(painted.pixels)}}};
}

}  // namespace hearth
