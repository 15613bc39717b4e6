#include "viewer/walk/controls.h"

#include <algorithm>
#include <cmath>

namespace hearth {

namespace {

// In 1/1000 degree: by keys, 128 degrees a second to the side and 64 up; by a stick, at most 192
// and 96.
constexpr int kKeyTurn = 128000 / kTicksPerSecond;
constexpr int kKeyPitch = 64000 / kTicksPerSecond;
constexpr double kStickTurn = 192000.0 / kTicksPerSecond;
constexpr double kStickPitch = 96000.0 / kTicksPerSecond;

/// What sticks and triggers report at their end, and what resting ones may.
constexpr double kAxisEnd = 32767;
constexpr double kDeadZone = 8000;

/// Motions of the mouse that no hand makes, in pixels and in 1/1000 degree: keep sums in an int.
constexpr int kMaxPixels = 1 << 14;
constexpr int kMaxMotion = 1000000000;

struct ButtonBinding {
  GamepadButton button;
  Action action;
};
/// Of all buttons.
constexpr std::array kButtons = {
    ButtonBinding{GamepadButton::A, Action::Jump},
    ButtonBinding{GamepadButton::B, Action::Crouch},
    ButtonBinding{GamepadButton::X, Action::Use},
    ButtonBinding{GamepadButton::Y, Action::Fly},
};

std::size_t indexOf(Action action) { return static_cast<std::size_t>(action); }
std::size_t indexOf(GamepadAxis axis) { return static_cast<std::size_t>(axis); }
std::size_t indexOf(GamepadButton button) { return static_cast<std::size_t>(button); }

void add(int& pending, int motion) {
  pending = std::clamp(pending + motion, -kMaxMotion, kMaxMotion);
}

/// Takes this tick's part of what is to be spread over all that are due.
int takePart(int& pending, int ticksDue) {
  const int part = pending / ticksDue;
  pending -= part;
  return part;
}

int fraction(double stick, int keys) {
  const int sum = keys + static_cast<int>(std::lround(kFullSpeed * stick));
  return std::clamp(sum, -kFullSpeed, kFullSpeed);
}

}  // namespace

void Controls::setPreferences(const Preferences& preferences) {
  preferences_ = preferences;
  release();
}

std::optional<Action> Controls::handle(const Event& event) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) return handleKey(*key);
  if (const auto* button = std::get_if<GamepadButtonEvent>(&event)) return handleButton(*button);
  if (const auto* motion = std::get_if<MouseMotion>(&event)) look(*motion);
  if (const auto* moved = std::get_if<GamepadMotion>(&event))
    axes_[indexOf(moved->axis)] = moved->value;
  if (std::holds_alternative<GamepadRemoved>(event)) {
    axes_.fill(0);
    buttons_.reset();
  }
  return std::nullopt;
}

std::optional<Action> Controls::handleKey(const KeyEvent& key) {
  if (!key.isDown) {
    keys_.reset(indexOf(key.key));
    return std::nullopt;
  }
  const std::optional<Action> action = preferences_.keys.actionOf(key.key);
  const bool isAlt = key.hasAlt;
  if (!action || isAlt) return std::nullopt;
  keys_.set(indexOf(key.key));
  const bool canRepeat = *action == Action::ZoomIn || *action == Action::ZoomOut;
  if (key.isRepeat && !canRepeat) return std::nullopt;
  pressed_.set(indexOf(*action));
  return action;
}

std::optional<Action> Controls::handleButton(const GamepadButtonEvent& event) {
  buttons_.set(indexOf(event.button), event.isDown);
  if (!event.isDown) return std::nullopt;
  const auto found = std::ranges::find(kButtons, event.button, &ButtonBinding::button);
  pressed_.set(indexOf(found->action));
  return found->action;
}

void Controls::look(const MouseMotion& motion) {
  if (!isMouseCaptured_) return;
  add(mouse_.turn, motionOf(motion.right));
  add(mouse_.pitch, (preferences_.invertsPitch ? 1 : -1) * motionOf(motion.down));
}

void Controls::release() {
  keys_.reset();
  buttons_.reset();
  axes_.fill(0);
  pressed_.reset();
  mouse_ = {};
}

WalkInput Controls::nextTick(int ticksDue, double pitch) {
  const Vec2 walk = stick(GamepadAxis::LeftX, GamepadAxis::LeftY);
  const Vec2 look = stick(GamepadAxis::RightX, GamepadAxis::RightY);
  const auto rate = [](double full, double stick) {
    return static_cast<int>(std::lround(full * stick));
  };
  WalkInput input;
  input.forward = fraction(-walk.y, kFullSpeed * direction(Action::Backward, Action::Forward));
  input.right = fraction(walk.x, kFullSpeed * direction(Action::StrafeLeft, Action::StrafeRight));
  input.up = kFullSpeed * direction(Action::Crouch, Action::Jump);
  input.turn = kKeyTurn * direction(Action::TurnLeft, Action::TurnRight) +
               rate(kStickTurn, look.x) + takePart(mouse_.turn, ticksDue);
  input.pitch = kKeyPitch * direction(Action::LookDown, Action::LookUp) +
                rate(kStickPitch, -look.y) + takePart(mouse_.pitch, ticksDue);
  if (wants(Action::LookAhead)) input.pitch = static_cast<int>(std::lround(-1000 * pitch));
  input.run = wants(Action::Run) || isTriggerHeld();
  input.jump = wants(Action::Jump);
  input.crouch = wants(Action::Crouch);
  input.toggleFlight = pressed_[indexOf(Action::Fly)];
  input.use = pressed_[indexOf(Action::Use)];
  pressed_.reset();
  return input;
}

/// In 1/1000 degree.
int Controls::motionOf(int pixels) const {
  const auto perPixel = static_cast<int>(std::lround(1000 * preferences_.degreesPerPixel));
  return perPixel * std::clamp(pixels, -kMaxPixels, kMaxPixels);
}

bool Controls::wants(Action action) const {
  if (pressed_[indexOf(action)]) return true;
  for (const Key key : preferences_.keys.keysOf(action))
    if (keys_[indexOf(key)]) return true;
  return std::ranges::any_of(kButtons, [&](const ButtonBinding& binding) {
    return binding.action == action && buttons_[indexOf(binding.button)];
  });
}

int Controls::direction(Action less, Action more) const {
  return static_cast<int>(wants(more)) - static_cast<int>(wants(less));
}

/// From where it rests, to the right and down, no longer than 1. Both axes share a dead zone, so
/// that a stick works alike in all directions.
Vec2 Controls::stick(GamepadAxis horizontal, GamepadAxis vertical) const {
  const auto axis = [this](GamepadAxis id) { return static_cast<double>(axes_[indexOf(id)]); };
  const Vec2 at{axis(horizontal), axis(vertical)};
  const double tilt = length(at);
  if (tilt <= kDeadZone) return {};
  return std::min(1.0, (tilt - kDeadZone) / (kAxisEnd - kDeadZone)) / tilt * at;
}

bool Controls::isTriggerHeld() const {
  return std::max(axes_[indexOf(GamepadAxis::LeftTrigger)],
                  axes_[indexOf(GamepadAxis::RightTrigger)]) > kAxisEnd / 2;
}

}  // namespace hearth
