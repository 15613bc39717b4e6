#pragma once

#include <vector>

#include "level/ids.h"

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
  double s = 0;      ///< upright: metres along the authored wall, for the texture
  double share = 0;  ///< upright: of the way from the segment's p0 to its p1
  double zRef = 0;   ///< upright: the absolute height at which v is 0
};

/// Work of one frame, in the engine's own nouns.
struct FrameStats {
  int viewports = 0;    ///< sectors seen through side portals, and the first
  int flatPortals = 0;  ///< looks through an interface
  int segments = 0;     ///< projected
  std::size_t spans = 0;

  friend bool operator==(const FrameStats&, const FrameStats&) = default;
};

/// What shows where: every pixel of the frame lies in exactly one span.
struct VisibleSpans {
  std::vector<Span> spans;
  FrameStats stats;
};

}  // namespace hearth
