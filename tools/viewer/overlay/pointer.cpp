#include "viewer/overlay/pointer.h"

#include <utility>

namespace hearth {

namespace {

bool isShift(Key place) { return place == Key::LeftShift || place == Key::RightShift; }

}  // namespace

std::optional<Axis> axisOf(const KeyEvent& key) {
  if (key.hasCtrl) return std::nullopt;
  switch (key.letter) {
    case 'x':
      return Axis::X;
    case 'y':
      return Axis::Y;
    case 'z':
      return Axis::Z;
    default:
      return std::nullopt;
  }
}

PointerEvent Pointer::eventAt(PointerEvent::Kind kind, int x, int y) const {
  return {kind, {static_cast<double>(x), static_cast<double>(y)}, isShifted_, axis_};
}

std::optional<PointerEvent> Pointer::handle(const Event& event, int panelLeft) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) handleKey(*key);
  if (const auto* motion = std::get_if<MouseMotion>(&event))
    return handleMotion(*motion, panelLeft);
  if (const auto* button = std::get_if<MouseButtonEvent>(&event))
    return handleButton(*button, panelLeft);
  return std::nullopt;
}

void Pointer::handleKey(const KeyEvent& key) {
  if (isShift(key.key)) isShifted_ = key.isDown;
  const std::optional<Axis> axis = axisOf(key);
  if (key.isDown && axis) axis_ = axis;
  if (!key.isDown && axis == axis_) axis_.reset();
}

std::optional<PointerEvent> Pointer::handleMotion(const MouseMotion& motion, int panelLeft) const {
  if (holder_ == Holder::Panel) return std::nullopt;
  if (holder_ == Holder::None && motion.x >= panelLeft) return std::nullopt;
  return eventAt(PointerEvent::Kind::Move, motion.x, motion.y);
}

std::optional<PointerEvent> Pointer::handleButton(const MouseButtonEvent& button, int panelLeft) {
  if (button.button != MouseButton::Left) return std::nullopt;
  if (!button.isDown) {
    if (std::exchange(holder_, Holder::None) != Holder::Picture) return std::nullopt;
    return eventAt(PointerEvent::Kind::Release, button.x, button.y);
  }
  holder_ = button.x < panelLeft ? Holder::Picture : Holder::Panel;
  if (holder_ == Holder::Panel) return std::nullopt;
  return eventAt(PointerEvent::Kind::Press, button.x, button.y);
}

}  // namespace hearth
