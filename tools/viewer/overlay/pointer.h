#pragma once

#include <cstdint>
#include <optional>

#include "math/vec.h"
#include "viewer/input/event.h"

namespace hearth {

enum class Axis : std::uint8_t { X, Y, Z };

/// What the mouse does in the picture beside the panel.
struct PointerEvent {
  enum class Kind : std::uint8_t { Move, Press, Release };

  Kind kind;
  Vec2 pixel;  ///< of the picture; while the button is held perhaps beside it
  bool isShifted = false;
  std::optional<Axis> axis = {};  ///< whose key is held
};

/// Tells whose the left button is while the overlay is open: where it was pressed, until it is let
/// go of.
class Pointer {
 public:
  /// The part of an event that concerns the picture, which lies left of the column `panelLeft`.
  std::optional<PointerEvent> handle(const Event& event, int panelLeft);
  void release() {
    holder_ = Holder::None;
    axis_.reset();
  }

 private:
  enum class Holder : std::uint8_t { None, Picture, Panel };

  std::optional<PointerEvent> handleMotion(const MouseMotion& motion, int panelLeft) const;
  std::optional<PointerEvent> handleButton(const MouseButtonEvent& button, int panelLeft);
  void handleKey(const KeyEvent& key);
  PointerEvent eventAt(PointerEvent::Kind kind, int x, int y) const;

  Holder holder_ = Holder::None;
  bool isShifted_ = false;
  std::optional<Axis> axis_;
};

/// That the key x, y or z names, without Ctrl.
std::optional<Axis> axisOf(const KeyEvent& key);

}  // namespace hearth
