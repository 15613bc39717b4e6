#pragma once

#include <cstddef>
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
  double s = 0;         ///< upright: metres along the authored wall, for the texture
  double fraction = 0;  ///< upright: of the way from the segment's p0 to its p1
  double zRef = 0;      ///< upright: the absolute height at which v is 0
};

/// Work of a frame's first phase, in the engine's own nouns.
struct FrameStats {
  int viewports = 0;             ///< sectors seen through side portals, and the first
  int flatPortals = 0;           ///< looks through a flat portal
  std::size_t windows = 0;       ///< of both
  int segments = 0;              ///< projected
  std::size_t wallColumns = 0;   ///< columns of walls in view
  std::size_t stackColumns = 0;  ///< of those, of walls that are stacks
  std::size_t slopeColumns = 0;  ///< of those, of walls along which floor or ceiling rises
  std::size_t spans = 0;
  std::size_t maskedMiddleSpans = 0;  ///< of those, of masked middle textures

  FrameStats& operator+=(const FrameStats& other) {
    viewports += other.viewports;
    flatPortals += other.flatPortals;
    windows += other.windows;
    segments += other.segments;
    wallColumns += other.wallColumns;
    stackColumns += other.stackColumns;
    slopeColumns += other.slopeColumns;
    spans += other.spans;
    maskedMiddleSpans += other.maskedMiddleSpans;
    return *this;
  }
  friend bool operator==(const FrameStats&, const FrameStats&) = default;
};

/// Work of its second: of the spans that were painted, those for which more had to be done.
struct PaintStats {
  std::size_t slopeSpans = 0;     ///< on slopes and their sidewalls
  std::size_t lightmapSpans = 0;  ///< with light that differs from pixel to pixel ...
  std::size_t coloredSpans = 0;   ///< ... in each channel
  std::size_t lightmapPixels = 0;
  std::size_t pixels = 0;

  PaintStats& operator+=(const PaintStats& other) {
    slopeSpans += other.slopeSpans;
    lightmapSpans += other.lightmapSpans;
    coloredSpans += other.coloredSpans;
    lightmapPixels += other.lightmapPixels;
    pixels += other.pixels;
    return *this;
  }
  friend bool operator==(const PaintStats&, const PaintStats&) = default;
};

/// What shows where: every pixel of the frame lies in exactly one span of what has no holes. Those
/// of masked middle textures come behind all of these, from far to near in each pixel.
struct VisibleSpans {
  std::vector<Span> spans;
  FrameStats stats;
};

}  // namespace hearth
