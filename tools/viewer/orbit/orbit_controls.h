#pragma once

#include <bitset>

#include "viewer/input/actions.h"
#include "viewer/input/event.h"
#include "viewer/input/key.h"
#include "viewer/orbit/orbit.h"

namespace hearth {

/// Mouse and keys by which a model is turned. These keys are the same for everyone. A key that the
/// user's settings give to an action that models have, too, does only that.
class OrbitControls {
 public:
  /// Takes what the event says about the model. `keys` are those of the user.
  void handle(const Event& event, const KeyMap& keys);
  /// Releases everything.
  void release();

  /// The input of the next tick. `ticksDue` >= 1 ticks are due at once, this one included: the
  /// mouse's motion is spread over them.
  OrbitInput nextTick(int ticksDue);
  /// Whether the whole model is asked for, since the last call.
  bool takeHome();

 private:
  void handleKey(const KeyEvent& key, const KeyMap& keys);
  bool wants(Key key) const { return held_[indexOf(key)] || pressed_[indexOf(key)]; }
  int direction(Key less, Key more) const;
  int direction(Key less, Key otherLess, Key more, Key otherMore) const;

  std::bitset<kKeyCount> held_;
  std::bitset<kKeyCount> pressed_;  ///< since the last tick, even if released again
  bool isDragging_ = false;
  double turn_ = 0;  ///< by the mouse, and not yet done; degrees
  double tilt_ = 0;
  int notches_ = 0;  ///< of the wheel, towards the model
  bool wantsHome_ = false;
};

}  // namespace hearth
