#include "desktop/sdl_events.h"

#include <SDL_events.h>

namespace hearth {

namespace {

static_assert(kKeyCount == SDL_NUM_SCANCODES);

KeyEvent keyEventFrom(const SDL_KeyboardEvent& key) {
  const SDL_Keycode code = key.keysym.sym;
  const auto holds = [&key](int modifiers) { return (key.keysym.mod & modifiers) != 0; };
  return {static_cast<Key>(key.keysym.scancode),
          key.type == SDL_KEYDOWN,
          key.repeat != 0,
          code >= SDLK_a && code <= SDLK_z ? static_cast<char>(code) : char{},
          holds(KMOD_SHIFT),
          holds(KMOD_CTRL),
          holds(KMOD_ALT)};
}

MouseButton mouseButtonFrom(Uint8 button) {
  switch (button) {
    case SDL_BUTTON_LEFT:
      return MouseButton::Left;
    case SDL_BUTTON_RIGHT:
      return MouseButton::Right;
    case SDL_BUTTON_MIDDLE:
      return MouseButton::Middle;
    default:
      return MouseButton::Other;
  }
}

std::optional<GamepadAxis> gamepadAxisFrom(Uint8 axis) {
  switch (axis) {
    case SDL_CONTROLLER_AXIS_LEFTX:
      return GamepadAxis::LeftX;
    case SDL_CONTROLLER_AXIS_LEFTY:
      return GamepadAxis::LeftY;
    case SDL_CONTROLLER_AXIS_RIGHTX:
      return GamepadAxis::RightX;
    case SDL_CONTROLLER_AXIS_RIGHTY:
      return GamepadAxis::RightY;
    case SDL_CONTROLLER_AXIS_TRIGGERLEFT:
      return GamepadAxis::LeftTrigger;
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT:
      return GamepadAxis::RightTrigger;
    default:
      return std::nullopt;
  }
}

std::optional<Event> gamepadMotionFrom(const SDL_ControllerAxisEvent& motion) {
  const auto axis = gamepadAxisFrom(motion.axis);
  if (!axis) return std::nullopt;
  return GamepadMotion{*axis, motion.value};
}

std::optional<Event> gamepadButtonFrom(const SDL_ControllerButtonEvent& button) {
  const bool isDown = button.type == SDL_CONTROLLERBUTTONDOWN;
  switch (button.button) {
    case SDL_CONTROLLER_BUTTON_A:
      return GamepadButtonEvent{GamepadButton::A, isDown};
    case SDL_CONTROLLER_BUTTON_B:
      return GamepadButtonEvent{GamepadButton::B, isDown};
    case SDL_CONTROLLER_BUTTON_Y:
      return GamepadButtonEvent{GamepadButton::Y, isDown};
    case SDL_CONTROLLER_BUTTON_X:
      return GamepadButtonEvent{GamepadButton::X, isDown};
    default:
      return std::nullopt;
  }
}

WindowEvent windowEventFrom(const SDL_WindowEvent& window) {
  switch (window.event) {
    case SDL_WINDOWEVENT_FOCUS_LOST:
      return WindowEvent::FocusLost;
    case SDL_WINDOWEVENT_LEAVE:
      return WindowEvent::MouseLeft;
    default:
      return WindowEvent::Changed;
  }
}

}  // namespace

std::optional<Event> eventFrom(const SDL_Event& event) {
  switch (event.type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      return keyEventFrom(event.key);
    case SDL_TEXTINPUT:
      return TypedText{event.text.text};
    case SDL_MOUSEMOTION:
      return MouseMotion{event.motion.x, event.motion.y, event.motion.xrel, event.motion.yrel};
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      return MouseButtonEvent{mouseButtonFrom(event.button.button),
                              event.type == SDL_MOUSEBUTTONDOWN, event.button.x, event.button.y};
    case SDL_MOUSEWHEEL:
      return WheelTurn{event.wheel.x, event.wheel.y};
    case SDL_CONTROLLERAXISMOTION:
      return gamepadMotionFrom(event.caxis);
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
      return gamepadButtonFrom(event.cbutton);
    case SDL_CONTROLLERDEVICEREMOVED:
      return GamepadRemoved{};
    case SDL_WINDOWEVENT:
      return windowEventFrom(event.window);
    case SDL_QUIT:
      return WindowEvent::CloseAsked;
    default:
      return std::nullopt;
  }
}

}  // namespace hearth
