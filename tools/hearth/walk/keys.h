#pragma once

#include <SDL_scancode.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hearth {

/// What a key or a button asks for.
enum class Action : std::uint8_t {
  Forward,
  Backward,
  StepLeft,
  StepRight,
  TurnLeft,
  TurnRight,
  LookUp,
  LookDown,
  LookAhead,
  Run,
  Jump,
  Crouch,
  Fly,
  ShowBoth,
  ShowTextures,
  ShowLight,
  Map,
  ZoomIn,
  ZoomOut,
  Screenshot,
  FullScreen,
  Keys,
  Overlay,
  Leave,
};
inline constexpr std::size_t kActionCount = static_cast<std::size_t>(Action::Leave) + 1;

/// A place on the keyboard: keys keep theirs where letters lie otherwise.
struct KeyBinding {
  SDL_Scancode code = SDL_SCANCODE_UNKNOWN;
  Action action{};
};

/// A row of the table that input, the list on the screen and `--help` are made from.
struct KeyRow {
  std::string_view names;  ///< as on a US keyboard
  std::string_view help;
  std::array<KeyBinding, 5> bindings{};  ///< none for mouse and gamepad
};

std::span<const KeyRow> keyTable();

std::optional<Action> actionOf(SDL_Scancode code);

/// The table as text, a line for each row.
std::string keyHelp();

}  // namespace hearth
