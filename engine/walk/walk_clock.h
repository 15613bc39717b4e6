#pragma once

#include <optional>

namespace hearth {

/// Turns the time of a clock, whatever it does, into ticks of fixed length. Its owner reads the
/// clock; so a test can be one.
class WalkClock {
 public:
  struct Due {
    int ticks = 0;        ///< to simulate now
    double fraction = 0;  ///< [0, 1): how far the present is into the tick after these
  };

  /// What is due at `now`, in seconds from any origin. The first call starts the clock. At most a
  /// quarter of a second is made up for and the rest forgotten, so that a pause is no leap; a clock
  /// that is set back (or says no number) makes nothing due and goes on from there.
  Due advance(double now);

 private:
  std::optional<double> last_;
  double pendingTicks_ = 0;  // time that has passed and was not simulated, in ticks
};

}  // namespace hearth
