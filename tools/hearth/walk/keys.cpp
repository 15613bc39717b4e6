#include "hearth/walk/keys.h"

#include <fmt/format.h>

#include <iterator>

namespace hearth {

namespace {

constexpr std::array kTable = {
    KeyRow{"W S, Up Down",
           "walk",
           {{{SDL_SCANCODE_W, Action::Forward},
             {SDL_SCANCODE_UP, Action::Forward},
             {SDL_SCANCODE_S, Action::Backward},
             {SDL_SCANCODE_DOWN, Action::Backward}}}},
    KeyRow{"A D",
           "step to the side",
           {{{SDL_SCANCODE_A, Action::StepLeft}, {SDL_SCANCODE_D, Action::StepRight}}}},
    KeyRow{"Left Right",
           "turn",
           {{{SDL_SCANCODE_LEFT, Action::TurnLeft}, {SDL_SCANCODE_RIGHT, Action::TurnRight}}}},
    KeyRow{"PageUp PageDown",
           "look up and down",
           {{{SDL_SCANCODE_PAGEUP, Action::LookUp}, {SDL_SCANCODE_PAGEDOWN, Action::LookDown}}}},
    KeyRow{"Home, End",
           "look straight ahead",
           {{{SDL_SCANCODE_HOME, Action::LookAhead}, {SDL_SCANCODE_END, Action::LookAhead}}}},
    KeyRow{
        "Shift", "run", {{{SDL_SCANCODE_LSHIFT, Action::Run}, {SDL_SCANCODE_RSHIFT, Action::Run}}}},
    KeyRow{"Space", "jump; in flight: up", {{{SDL_SCANCODE_SPACE, Action::Jump}}}},
    KeyRow{"C, Ctrl",
           "crouch; in flight: down",
           {{{SDL_SCANCODE_C, Action::Crouch},
             {SDL_SCANCODE_LCTRL, Action::Crouch},
             {SDL_SCANCODE_RCTRL, Action::Crouch}}}},
    KeyRow{"N", "fly, or walk again", {{{SDL_SCANCODE_N, Action::Fly}}}},
    KeyRow{"1 2 3",
           "textures and light, one alone",
           {{{SDL_SCANCODE_1, Action::ShowBoth},
             {SDL_SCANCODE_2, Action::ShowTextures},
             {SDL_SCANCODE_3, Action::ShowLight}}}},
    KeyRow{"Tab, + -",
           "map of what was seen, its zoom",
           {{{SDL_SCANCODE_TAB, Action::Map},
             {SDL_SCANCODE_EQUALS, Action::ZoomIn},
             {SDL_SCANCODE_KP_PLUS, Action::ZoomIn},
             {SDL_SCANCODE_MINUS, Action::ZoomOut},
             {SDL_SCANCODE_KP_MINUS, Action::ZoomOut}}}},
    KeyRow{"F1", "overlay: figures, settings", {{{SDL_SCANCODE_F1, Action::Overlay}}}},
    KeyRow{"F11", "full screen, or window again", {{{SDL_SCANCODE_F11, Action::FullScreen}}}},
    KeyRow{"F12", "save the picture as a PNG", {{{SDL_SCANCODE_F12, Action::Screenshot}}}},
    KeyRow{"H", "show these keys", {{{SDL_SCANCODE_H, Action::Keys}}}},
    KeyRow{"Esc", "close overlay, free mouse, leave", {{{SDL_SCANCODE_ESCAPE, Action::Leave}}}},
    KeyRow{"Mouse", "look, after a click"},
    KeyRow{"Gamepad", "left stick walks, right one looks"},
    KeyRow{"A B Y, triggers", "jump, crouch, fly, run"},
};

}  // namespace

std::span<const KeyRow> keyTable() { return kTable; }

std::optional<Action> actionOf(SDL_Scancode code) {
  if (code == SDL_SCANCODE_UNKNOWN) return std::nullopt;
  for (const KeyRow& row : kTable)
    for (const KeyBinding& binding : row.bindings)
      if (binding.code == code) return binding.action;
  return std::nullopt;
}

std::string keyHelp() {
  std::string help;
  for (const KeyRow& row : kTable)
    fmt::format_to(std::back_inserter(help), "  {:<16}{}\n", row.names, row.help);
  return help;
}

}  // namespace hearth
