#include "viewer/orbit/orbit_controls.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "walk/walk_input.h"

namespace hearth {

namespace {

// By keys, a full turn takes 3.75 s, and in a second the distance changes by a factor of 3.5.
constexpr double kTurnByKey = 96.0 / kTicksPerSecond;  // degrees a tick
constexpr double kTiltByKey = 48.0 / kTicksPerSecond;
constexpr double kZoomByKey = 1.02;  // a tick

/// A drag of 960 points turns the model once round.
constexpr double kTurnByPoint = 0.375;  // degrees
constexpr double kZoomByNotch = 1.15;

/// No hand makes more of these in a tick.
constexpr int kMaxNotches = 64;
constexpr double kMaxTurn = 3600;  // degrees

void addTurn(double& pending, int points) {
  pending = std::clamp(pending + kTurnByPoint * points, -kMaxTurn, kMaxTurn);
}

double takeShare(double& pending, int ticksDue) {
  const double share = pending / ticksDue;
  pending -= share;
  return share;
}

/// `factor` to the power of `count`.
double repeated(double factor, int count) {
  double product = 1;
  for (int i = 0; i < std::abs(count); ++i) product *= factor;
  return count < 0 ? 1 / product : product;
}

}  // namespace

void OrbitControls::handle(const Event& event, const KeyMap& keys) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) handleKey(*key, keys);
  if (const auto* button = std::get_if<MouseButtonEvent>(&event);
      button && button->button == MouseButton::Left)
    isDragging_ = button->isDown;
  if (const auto* motion = std::get_if<MouseMotion>(&event); motion && isDragging_) {
    addTurn(turn_, motion->right);
    addTurn(tilt_, motion->down);
  }
  if (const auto* wheel = std::get_if<WheelTurn>(&event))
    notches_ = std::clamp(notches_ + wheel->up, -kMaxNotches, kMaxNotches);
}

void OrbitControls::handleKey(const KeyEvent& key, const KeyMap& keys) {
  if (!key.isDown) {
    held_.reset(indexOf(key.key));
    return;
  }
  const std::optional<Action> action = keys.actionOf(key.key);
  if (key.hasAlt || (action && isOfModels(*action))) return;
  held_.set(indexOf(key.key));
  if (!key.isRepeat) pressed_.set(indexOf(key.key));
  wantsHome_ |= key.key == Key::Home;
}

void OrbitControls::release() { *this = {}; }

OrbitInput OrbitControls::nextTick(int ticksDue) {
  OrbitInput input;
  input.turn =
      kTurnByKey * direction(Key::Left, Key::A, Key::Right, Key::D) + takeShare(turn_, ticksDue);
  input.tilt =
      kTiltByKey * direction(Key::Up, Key::E, Key::Down, Key::Q) + takeShare(tilt_, ticksDue);
  const int farther =
      std::clamp(direction(Key::W, Key::S) +
                     direction(Key::Equals, Key::KeypadPlus, Key::Minus, Key::KeypadMinus),
                 -1, 1);
  input.zoom = repeated(kZoomByKey, farther) * repeated(kZoomByNotch, -std::exchange(notches_, 0));
  pressed_.reset();
  return input;
}

bool OrbitControls::takeHome() { return std::exchange(wantsHome_, false); }

int OrbitControls::direction(Key less, Key more) const {
  return static_cast<int>(wants(more)) - static_cast<int>(wants(less));
}

int OrbitControls::direction(Key less, Key otherLess, Key more, Key otherMore) const {
  return std::clamp(direction(less, more) + direction(otherLess, otherMore), -1, 1);
}

}  // namespace hearth
