#pragma once

#include <SDL_events.h>

#include <cstdint>
#include <optional>

#include "math/vec.h"

namespace hearth {

/// What the mouse does in the picture beside the panel.
struct PointerEvent {
  enum class Kind : std::uint8_t { Move, Press, Release };

  Kind kind;
  Vec2 pixel;  ///< of the picture; while the button is held perhaps beside it
  bool isShifted = false;
};

/// Tells whose the left button is while the overlay is open: where it was pressed, until it is let
/// go of.
class Pointer {
 public:
  /// What of an event is for the picture: for what is left of the column `panelLeft`.
  std::optional<PointerEvent> take(const SDL_Event& event, int panelLeft);
  void release() { holder_ = Holder::None; }

 private:
  enum class Holder : std::uint8_t { None, Picture, Panel };

  std::optional<PointerEvent> take(const SDL_MouseButtonEvent& button, int panelLeft);

  Holder holder_ = Holder::None;
  bool isShifted_ = false;
};

}  // namespace hearth
