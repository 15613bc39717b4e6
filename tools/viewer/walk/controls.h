#pragma once

#include <array>
#include <bitset>
#include <optional>

#include "math/vec.h"
#include "viewer/input/event.h"
#include "viewer/preferences/preferences.h"
#include "walk/walk_input.h"

namespace hearth {

/// Keyboard, mouse and gamepad as they are now, and what that asks of the walker in a tick.
class Controls {
 public:
  /// Lets go of everything, as keys may mean something else now.
  void setPreferences(const Preferences& preferences);
  const Preferences& preferences() const { return preferences_; }

  /// What the event asks for besides movement: the action of a key or button that was pressed.
  std::optional<Action> take(const Event& event);

  /// The mouse looks around only while it is captured.
  void captureMouse(bool isCaptured) { isMouseCaptured_ = isCaptured; }
  bool isMouseCaptured() const { return isMouseCaptured_; }

  /// Lets go of everything, as when another window gets the keyboard.
  void release();

  /// What is asked for in the next tick. `ticksDue` >= 1 are to come at once, this one among them:
  /// the mouse's motion is spread over them, and none of it is lost. `pitch`, in degrees, is where
  /// the walker looks; from there a key leads back to looking ahead.
  WalkInput nextTick(int ticksDue, double pitch);

 private:
  struct Motion {
    int turn = 0;  ///< 1/1000 degree, to the right
    int pitch = 0;
  };

  std::optional<Action> takeKey(const KeyEvent& key);
  std::optional<Action> takeButton(const GamepadButtonEvent& event);
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
  std::bitset<kActionCount> pressed_;  ///< since the last tick, even if let go again
  Motion mouse_;                       ///< since the last tick
  bool isMouseCaptured_ = false;
};

}  // namespace hearth
