#pragma once

#include <optional>
#include <string>

#include "viewer/input/event.h"
#include "viewer/preferences/preferences.h"

namespace hearth {

/// A section of the overlay: mouse, steps and keys.
class PreferencesSection {
 public:
  /// Takes the next key for the action whose key is to change, and gives it that in `preferences`;
  /// Esc leaves all as it was. Returns whether the event was for it.
  bool handle(const Event& event, Preferences& preferences);

  /// Returns whether what has been changed in `preferences` can be written: nothing is dragged any
  /// more.
  bool show(Preferences& preferences);

  /// Waits for no key any more.
  void giveUp() { asked_.reset(); }

 private:
  struct Asked {
    Action action;
    std::optional<Key> replaced;  ///< else the key is added
  };

  void showKeys(Preferences& preferences);
  void showKeysOf(Action action, Preferences& preferences);
  void give(Key key, Preferences& preferences);

  std::optional<Asked> asked_;
  std::string told_;  ///< of the last key
  bool isChanged_ = false;
};

}  // namespace hearth
