#pragma once

#include <optional>

namespace hearth {

/// Turns the time of any clock into ticks of fixed length. The owner reads the clock, so a test can
/// be the clock.
class WalkClock {
 public:
  struct Due {
    int ticks = 0;        ///< to simulate now
    double fraction = 0;  ///< [0, 1): how far the present is into the tick after these
  };

  /// The ticks that are due at `now`, in seconds from any origin. The first call starts the clock.
  /// After a pause at most a quarter of a second is made up for. If the clock is set back, or gives
  /// no number, nothing is due, and time goes on from there.
  Due advance(double now);

 private:
  std::optional<double> last_;
  double pendingTicks_ = 0;  // time that has passed and was not simulated, in ticks
};

}  // namespace hearth
