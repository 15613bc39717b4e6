#pragma once

namespace hearth {

/// The simulation's fixed tick: 1/64 s is exact in binary.
inline constexpr int kTicksPerSecond = 64;

/// Full speed in WalkInput.
inline constexpr int kFullSpeed = 127;

/// The player's input for one tick, in integers, so that a recording is exact. Speeds beyond full
/// speed count as full.
struct WalkInput {
  int forward = 0;  ///< -127..127; fraction of full speed
  int right = 0;    ///< -127..127
  int up = 0;       ///< -127..127, in flight only
  int turn = 0;     ///< 1/1000 degree in this tick, to the right
  int pitch = 0;    ///< 1/1000 degree in this tick, upwards
  bool run = false;
  bool jump = false;          ///< held
  bool crouch = false;        ///< held
  bool toggleFlight = false;  ///< pressed in this tick
  bool use = false;           ///< likewise

  friend bool operator==(const WalkInput&, const WalkInput&) = default;
};

}  // namespace hearth
