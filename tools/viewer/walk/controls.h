#pragma once

#include <array>
#include <bitset>
#include <optional>

#include "math/vec.h"
#include "viewer/input/event.h"
#include "viewer/preferences/preferences.h"
#include "walk/walk_input.h"

namespace hearth {

/// The state of keyboard, mouse and gamepad, and the input of a tick that follows from it.
class Controls {
 public:
  /// Releases everything, because keys may have other actions now.
  void setPreferences(const Preferences& preferences);
  const Preferences& preferences() const { return preferences_; }

  /// The action of the event besides movement: that of a key or button that is pressed.
  std::optional<Action> handle(const Event& event);

  /// The mouse looks around only while it is captured.
  void captureMouse(bool isCaptured) { isMouseCaptured_ = isCaptured; }
  bool isMouseCaptured() const { return isMouseCaptured_; }

  /// Releases everything, for example when another window gets the keyboard.
  void release();

  /// The input of the next tick. `ticksDue` >= 1 ticks are due at once, this one included: the
  /// mouse's motion is spread over them, and none of it is lost. `pitch` is that of the walker, in
  /// degrees; a key leads from it back to the horizon.
  WalkInput nextTick(int ticksDue, double pitch);

 private:
  struct Motion {
    int turn = 0;  ///< 1/1000 degree, to the right
    int pitch = 0;
  };

  std::optional<Action> handleKey(const KeyEvent& key);
  std::optional<Action> handleButton(const GamepadButtonEvent& event);
  void look(const MouseMotion& motion);
  int motionOf(int pixels) const;
  bool wants(Action action) const;
  int direction(Action less, Action more) const;  ///< -1, 0 or 1
  Vec2 stick(GamepadAxis horizontal, GamepadAxis vertical) const;
  bool isTriggerHeld() const;

  Preferences preferences_;
  std::bitset<kKeyCount> keys_;
  std::bitset<kGamepadButtonCount> buttons_;
  std::array<int, kGamepadAxisCount> axes_{};
  std::bitset<kActionCount> pressed_;  ///< since the last tick, even if released again
  Motion mouse_;                       ///< since the last tick
  bool isMouseCaptured_ = false;
};

}  // namespace hearth
