#pragma once

#include "level/mover.h"

namespace hearth {

/// A mover after some ticks.
struct MoverState {
  double share = 0;   ///< 0 where it is authored .. 1 at `to`
  int direction = 0;  ///< 1 towards `to`, -1 back, 0 at rest
  int rested = 0;     ///< ticks at rest, where it will leave by itself

  friend bool operator==(const MoverState&, const MoverState&) = default;
};

/// Where a walk finds it.
MoverState firstState(const Mover& mover);

/// What the player's touch does: a mover that is at rest or on its way back sets out for `to`, and
/// one that waits there waits anew.
MoverState started(const Mover& mover, MoverState state);

/// One tick later. `distance` is that between its ends, in metres.
MoverState moved(const Mover& mover, double distance, MoverState state);

}  // namespace hearth
