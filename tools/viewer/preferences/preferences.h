#pragma once

#include "viewer/input/actions.h"

namespace hearth {

/// How a walk is steered and felt, as its user likes it. None of it changes what a recording means.
struct Preferences {
  KeyMap keys = {};
  double degreesPerPixel =
      0.15;                   ///< that the mouse moves; 0.01..10, hundredths of it at the finest
  bool invertsPitch = false;  ///< the mouse looks up when it is drawn near

  double viewBob = 0;  ///< 0..1, of what steps move the head

  friend bool operator==(const Preferences&, const Preferences&) = default;
};

inline constexpr double kLeastDegreesPerPixel = 0.01;
inline constexpr double kMaxDegreesPerPixel = 10;

}  // namespace hearth
