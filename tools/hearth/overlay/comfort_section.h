#pragma once

#include <SDL_events.h>

#include <optional>
#include <string>

#include "hearth/comfort/comfort.h"

namespace hearth {

/// A section of the overlay: mouse, steps and keys.
class ComfortSection {
 public:
  /// Takes the next key for the action whose key is to change, and gives it that in `comfort`; Esc
  /// leaves all as it was. Returns whether the event was for it.
  bool take(const SDL_Event& event, Comfort& comfort);

  /// Returns whether what has been changed in `comfort` can be written: nothing is dragged any
  /// more.
  bool show(Comfort& comfort);

  /// Waits for no key any more.
  void giveUp() { asked_.reset(); }

 private:
  struct Asked {
    Action action;
    std::optional<SDL_Scancode> replaced;  ///< else the key is added
  };

  void showKeys(Comfort& comfort);
  void showKeysOf(Action action, Comfort& comfort);
  void give(SDL_Scancode key, Comfort& comfort);

  std::optional<Asked> asked_;
  std::string told_;  ///< of the last key
  bool isChanged_ = false;
};

}  // namespace hearth
