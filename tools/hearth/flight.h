#pragma once

#include "level/level.h"

namespace hearth {

/// A free eye in a level: it has no body and no weight, but walls, floors and ceilings stop it.
struct Flight {
  SectorId sector;   ///< that contains `eye`
  Vec3 eye;          ///< metres, absolute
  double angle = 0;  ///< degrees, [0, 360)
  double pitch = 0;  ///< degrees upwards, -60..60
};

/// What drives the eye. Directions are -1, 0 or 1 each.
struct FlightControls {
  double forward = 0;
  double right = 0;
  double up = 0;
  double turn = 0;  ///< to the right, at an even speed
  bool isFast = false;
  double turnDegrees = 0;   ///< to the right, at once
  double pitchDegrees = 0;  ///< upwards, at once

  friend bool operator==(const FlightControls&, const FlightControls&) = default;
};

/// The flight `seconds` later. Times below 0 count as 0 and long ones as a quarter of a second, so
/// that a pause of the program is no leap. The eye leaves its sector through openings and flat
/// portals only, and slides along what stops it.
Flight advance(const Level& level, Flight flight, const FlightControls& controls, double seconds);

}  // namespace hearth
