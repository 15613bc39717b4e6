#include "viewer/overlay/pointer.h"

#include <SDL_keycode.h>

#include <utility>

namespace hearth {

namespace {

bool isShift(SDL_Scancode place) {
  return place == SDL_SCANCODE_LSHIFT || place == SDL_SCANCODE_RSHIFT;
}

}  // namespace

std::optional<Axis> axisOf(const SDL_KeyboardEvent& key) {
  if ((key.keysym.mod & KMOD_CTRL) != 0) return std::nullopt;
  switch (key.keysym.sym) {
    case SDLK_x:
      return Axis::X;
    case SDLK_y:
      return Axis::Y;
    case SDLK_z:
      return Axis::Z;
    default:
      return std::nullopt;
  }
}

PointerEvent Pointer::eventAt(PointerEvent::Kind kind, int x, int y) const {
  return {kind, {static_cast<double>(x), static_cast<double>(y)}, isShifted_, axis_};
}

std::optional<PointerEvent> Pointer::take(const SDL_Event& event, int panelLeft) {
  switch (event.type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      take(event.key);
      return std::nullopt;
    case SDL_MOUSEMOTION:
      if (holder_ == Holder::Panel) return std::nullopt;
      if (holder_ == Holder::None && event.motion.x >= panelLeft) return std::nullopt;
      return eventAt(PointerEvent::Kind::Move, event.motion.x, event.motion.y);
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      if (event.button.button != SDL_BUTTON_LEFT) return std::nullopt;
      return take(event.button, panelLeft);
    default:
      return std::nullopt;
  }
}

void Pointer::take(const SDL_KeyboardEvent& key) {
  const bool isDown = key.type == SDL_KEYDOWN;
  if (isShift(key.keysym.scancode)) isShifted_ = isDown;
  const std::optional<Axis> axis = axisOf(key);
  if (isDown && axis) axis_ = axis;
  if (!isDown && axis == axis_) axis_.reset();
}

std::optional<PointerEvent> Pointer::take(const SDL_MouseButtonEvent& button, int panelLeft) {
  if (button.type == SDL_MOUSEBUTTONUP) {
    if (std::exchange(holder_, Holder::None) != Holder::Picture) return std::nullopt;
    return eventAt(PointerEvent::Kind::Release, button.x, button.y);
  }
  holder_ = button.x < panelLeft ? Holder::Picture : Holder::Panel;
  if (holder_ == Holder::Panel) return std::nullopt;
  return eventAt(PointerEvent::Kind::Press, button.x, button.y);
}

}  // namespace hearth
