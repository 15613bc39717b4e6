#pragma once

#include <cmath>

namespace hearth {

/// Spaces frames evenly if their number per second is limited.
class FramePacer {
 public:
  /// Seconds until the next frame may be drawn. 0 means now; that frame then counts as drawn.
  /// `now` in seconds of a clock that may be set; `framesPerSecond` 0 for no limit.
  double secondsLeft(double now, double framesPerSecond) {
    const double period = framesPerSecond > 0 ? 1 / framesPerSecond : 0;
    const double wait = next_ - now;
    if (wait > 0 && wait <= period) return wait;
    // A frame that is late, or a clock that was set, begins a new beat.
    next_ = (std::abs(wait) < period ? next_ : now) + period;
    return 0;
  }

 private:
  double next_ = 0;  ///< when it may be drawn, in seconds of the clock
};

}  // namespace hearth
