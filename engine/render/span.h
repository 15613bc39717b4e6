#pragma once

#include <vector>

#include "level/ids.h"
#include "render/frame_stats.h"

namespace hearth {

/// Rows [rowBegin, rowEnd) of one column that show one surface.
struct Span {
  /// With it a list makes spans where they stay. A copy would wait until its parts are in memory.
  Span(int atColumn, int begin, int end, SurfaceId shown, double atDepth)
      : column(atColumn), rowBegin(begin), rowEnd(end), surface(shown), depth(atDepth) {}

  int column;
  int rowBegin;
  int rowEnd;
  SurfaceId surface;
  /// Depth in metres at which the column leaves the sector: the depth of an upright surface, and
  /// the greatest depth of a flat or slope.
  double depth;
  double s = 0;         ///< upright: metres along the authored wall, for the texture
  double fraction = 0;  ///< upright: of the way from the segment's p0 to p1
  double zRef = 0;      ///< upright: the absolute height at which v is 0
};

/// The spans of a frame. Every pixel lies in exactly one span of a surface without holes. The spans
/// of masked middle textures follow all of these, from far to near in each pixel.
struct VisibleSpans {
  std::vector<Span> spans;
  FrameStats stats;
};

}  // namespace hearth
