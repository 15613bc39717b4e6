#include "hearth/overlay/pointer.h"

#include <utility>

namespace hearth {

namespace {

bool isShift(SDL_Scancode place) {
  return place == SDL_SCANCODE_LSHIFT || place == SDL_SCANCODE_RSHIFT;
}

Vec2 at(int x, int y) { return {static_cast<double>(x), static_cast<double>(y)}; }

}  // namespace

std::optional<PointerEvent> Pointer::take(const SDL_Event& event, int panelLeft) {
  switch (event.type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      if (isShift(event.key.keysym.scancode)) isShifted_ = event.type == SDL_KEYDOWN;
      return std::nullopt;
    case SDL_MOUSEMOTION:
      if (holder_ == Holder::Panel) return std::nullopt;
      if (holder_ == Holder::None && event.motion.x >= panelLeft) return std::nullopt;
      return PointerEvent{PointerEvent::Kind::Move, at(event.motion.x, event.motion.y), isShifted_};
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      if (event.button.button != SDL_BUTTON_LEFT) return std::nullopt;
      return take(event.button, panelLeft);
    default:
      return std::nullopt;
  }
}

std::optional<PointerEvent> Pointer::take(const SDL_MouseButtonEvent& button, int panelLeft) {
  const Vec2 pixel = at(button.x, button.y);
  if (button.type == SDL_MOUSEBUTTONUP) {
    if (std::exchange(holder_, Holder::None) != Holder::Picture) return std::nullopt;
    return PointerEvent{PointerEvent::Kind::Release, pixel, isShifted_};
  }
  holder_ = button.x < panelLeft ? Holder::Picture : Holder::Panel;
  if (holder_ == Holder::Panel) return std::nullopt;
  return PointerEvent{PointerEvent::Kind::Press, pixel, isShifted_};
}

}  // namespace hearth
