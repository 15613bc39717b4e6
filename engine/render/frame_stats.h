#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace hearth {

/// The work of a frame's first phase.
struct FrameStats {
  int viewports = 0;             ///< sectors seen through side portals, and the first
  int flatPortals = 0;           ///< looks through a flat portal
  std::size_t windows = 0;       ///< of both
  int segments = 0;              ///< projected
  std::size_t sprites = 0;       ///< projected, once in each sector that they are seen in
  std::size_t faces = 0;         ///< of meshes, projected
  std::size_t wallColumns = 0;   ///< columns of walls in view
  std::size_t stackColumns = 0;  ///< of those, of walls that are stacks
  std::size_t slopeColumns = 0;  ///< of those, of walls along which floor or ceiling rises
  std::size_t spans = 0;
  std::size_t maskedSpans = 0;  ///< of those, of masked middle textures and things

  FrameStats& operator+=(const FrameStats& other) {
    viewports += other.viewports;
    flatPortals += other.flatPortals;
    windows += other.windows;
    segments += other.segments;
    sprites += other.sprites;
    faces += other.faces;
    wallColumns += other.wallColumns;
    stackColumns += other.stackColumns;
    slopeColumns += other.slopeColumns;
    spans += other.spans;
    maskedSpans += other.maskedSpans;
    return *this;
  }
  friend bool operator==(const FrameStats&, const FrameStats&) = default;
};

/// The work of its second phase: painted spans that cost more than others, and pixels.
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

/// One of these counts by its name, as a mean over frames. It is the same on every machine and in
/// every run.
struct FrameCounter {
  std::string_view name;  ///< stable: scripts read it
  double mean = 0;

  friend bool operator==(const FrameCounter&, const FrameCounter&) = default;
};
using FrameCounters = std::array<FrameCounter, 15>;
/// The counters of one frame.
FrameCounters countersOf(const FrameStats& found, const PaintStats& painted);

}  // namespace hearth
