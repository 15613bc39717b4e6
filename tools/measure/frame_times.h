#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "math/spread.h"
#include "render/frame_stats.h"
#include "render/renderer.h"
#include "settings/options.h"

namespace hearth {

/// The time in seconds, from any origin.
using Clock = std::function<double()>;
/// A clock that nobody sets.
double steadySeconds();

/// Frames of one size, of all shots of a level.
struct FrameBench {
  ImageSize size;
  int threads = 1;
  Spread milliseconds;  ///< a frame
  // Of its two phases:
  Spread findMilliseconds;  ///< for finding the spans
  Spread colorMilliseconds;
  /// One plain write of four bytes for each of its pixels, after each frame: the cost of
  /// memory alone.
  Spread writeMilliseconds;
  FrameCounters counters;

  /// How many times its memory could be written in the time of a frame.
  double writes() const { return milliseconds.median / writeMilliseconds.median; }
};

/// The cameras of a level's shots; of a level without shots the player's.
std::vector<Camera> camerasOf(const Level& level);

/// Frames of one size, with all times that were taken.
class FrameTimes {
 public:
  /// The workers, if any, help to draw. They must outlive it.
  explicit FrameTimes(ImageSize size, Workers* workers = nullptr);

  /// Draws a frame, and then writes memory of its size.
  void draw(const Renderer& renderer, Camera camera, const Clock& clock);

  /// Forgets the times and the work so far, but not the memory.
  void begin();

  /// The result of at least one frame.
  FrameBench result() const;

 private:
  void write(const Clock& clock);

  Workers* workers_;
  FrameBench bench_;
  std::vector<double> findMilliseconds_;
  std::vector<double> colorMilliseconds_;
  std::vector<double> writeMilliseconds_;
  std::vector<std::uint32_t> memory_;
  FrameScratch scratch_;
  PixelBuffer picture_;
};

}  // namespace hearth
