#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "viewer/input/key.h"

/// The events of a walk's window, from the user and from the desktop.
namespace hearth {

/// A key is pressed or released.
struct KeyEvent {
  Key key{};
  bool isDown = true;
  bool isRepeat = false;  ///< it was held already
  char letter = 0;        ///< lower case, of the key in the user's layout; 0 if it is none of a..z
  bool hasShift = false;  ///< which is held
  bool hasCtrl = false;
  bool hasAlt = false;
};

struct TypedText {
  std::string text;  ///< UTF-8
};

/// Positions, also below, are in pixels of the picture, or beside it.
struct MouseMotion {
  int x = 0;
  int y = 0;
  int right = 0;  ///< since the last event, in points of the desktop
  int down = 0;
};

enum class MouseButton : std::uint8_t { Left, Right, Middle, Other };
struct MouseButtonEvent {
  MouseButton button{};
  bool isDown = true;
  int x = 0;
  int y = 0;
};

/// In notches.
struct WheelTurn {
  int right = 0;
  int up = 0;
};

enum class GamepadAxis : std::uint8_t { LeftX, LeftY, RightX, RightY, LeftTrigger, RightTrigger };
inline constexpr std::size_t kGamepadAxisCount = 6;
struct GamepadMotion {
  GamepadAxis axis{};
  int value = 0;  ///< -32768..32767, to the right and down; of triggers from 0
};

enum class GamepadButton : std::uint8_t { A, B, X, Y };
inline constexpr std::size_t kGamepadButtonCount = 4;
struct GamepadButtonEvent {
  GamepadButton button{};
  bool isDown = true;
};

enum class WindowEvent : std::uint8_t {
  CloseAsked,
  FocusLost,
  MouseLeft,
  Changed,  ///< in size, place or otherwise: its picture may be gone
};

struct GamepadRemoved {};

using Event = std::variant<KeyEvent, TypedText, MouseMotion, MouseButtonEvent, WheelTurn,
                           GamepadMotion, GamepadButtonEvent, GamepadRemoved, WindowEvent>;

/// Whether the event is `window`.
inline bool is(const Event& event, WindowEvent window) {
  const auto* told = std::get_if<WindowEvent>(&event);
  return told && *told == window;
}

}  // namespace hearth
