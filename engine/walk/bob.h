#pragma once

#include "walk/walker.h"

namespace hearth {

/// How the head of a walker bobs with the steps. It moves only the view: no walk depends on it.
struct Gait {
  double stride = 0;  ///< metres walked on the ground
  double swing = 0;   ///< 0 at rest .. 1 running; follows the walker in an eighth of a second

  friend bool operator==(const Gait&, const Gait&) = default;
};

/// The gait after a tick that led from `before` to `after`.
Gait walkedOn(const Gait& gait, const Walker& before, const Walker& after);

/// The eye, raised or lowered by the gait. `strength` is 0..1. The eye stays in the air of its
/// sector.
Eye bobbed(const Scene& scene, const Eye& eye, const Gait& gait, double strength);

}  // namespace hearth
