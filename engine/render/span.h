#pragma once

#include <vector>

#include "level/ids.h"
#include "render/frame_stats.h"

namespace hearth {

/// Rows [rowBegin, rowEnd) of one column that show one surface.
struct Span {
  int column;
  int rowBegin;
  int rowEnd;
  SurfaceId surface;
  /// Depth in metres at which the column leaves the sector: that of an upright surface, and the
  /// farthest that a flat or slope can be.
  double depth;
  double s = 0;         ///< upright: metres along the authored wall, for the texture
  double fraction = 0;  ///< upright: of the way from the segment's p0 to its p1
  double zRef = 0;      ///< upright: the absolute height at which v is 0
};

/// What shows where: every pixel of the frame lies in exactly one span of what has no holes. Those
/// of masked middle textures come behind all of these, from far to near in each pixel.
struct VisibleSpans {
  std::vector<Span> spans;
  FrameStats stats;
};

}  // namespace hearth
