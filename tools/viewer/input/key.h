#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hearth {

/// A key by its place on the keyboard: it keeps its name where a layout has another letter there.
/// The numbers are usages of the keyboard page of the USB HID usage tables; from 256 on they are
/// SDL's, of keys that the page lacks. Only keys that the program itself names are listed.
enum class Key : std::uint16_t {
  None = 0,
  A = 4,
  B,
  C,
  D,
  E,
  F,
  G,
  H,
  I,
  J,
  K,
  L,
  M,
  N,
  O,
  P,
  Q,
  R,
  S,
  T,
  U,
  V,
  W,
  X,
  Y,
  Z,
  Digit1,
  Digit2,
  Digit3,
  Return = 40,
  Escape,
  Backspace,
  Tab,
  Space,
  Minus,
  Equals,
  Backslash = 49,
  F1 = 58,
  F2,
  F3,
  F4,
  F5,
  F6,
  F7,
  F8,
  F9,
  F10,
  F11,
  F12,
  Insert = 73,
  Home,
  PageUp,
  Delete,
  End,
  PageDown,
  Right,
  Left,
  Down,
  Up,
  KeypadMinus = 86,
  KeypadPlus,
  KeypadEnter,
  LeftCtrl = 224,
  LeftShift,
  LeftAlt,
  RightCtrl = 228,
  RightShift,
  RightAlt,
};
/// More than the number of any key.
inline constexpr std::size_t kKeyCount = 512;

inline constexpr std::size_t indexOf(Key key) { return static_cast<std::size_t>(key); }

/// As files name a key: by its place on a US keyboard, in SDL's words. Empty for numbers of no key.
std::string nameOf(Key key);
/// Letters may be small or capital.
std::optional<Key> keyNamed(std::string_view name);
std::vector<std::string_view> allKeyNames();

}  // namespace hearth
