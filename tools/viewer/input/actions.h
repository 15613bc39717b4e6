#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/input/key.h"

namespace hearth {

/// The actions of keys and buttons.
enum class Action : std::uint8_t {
  Forward,
  Backward,
  StrafeLeft,
  StrafeRight,
  TurnLeft,
  TurnRight,
  LookUp,
  LookDown,
  LookAhead,
  Run,
  Jump,
  Crouch,
  Fly,
  Use,
  ShowBoth,
  ShowTextures,
  ShowLight,
  Map,
  ZoomIn,
  ZoomOut,
  Bookmark,
  NextBookmark,
  Overlay,
  FullScreen,
  Screenshot,
  Keys,
  Leave,
};
inline constexpr std::size_t kActionCount = static_cast<std::size_t>(Action::Leave) + 1;

/// A row of the table of actions. Input, the user's settings and the lists of keys use the table.
struct ActionRow {
  Action action{};
  std::string_view name;      ///< in the user's settings
  std::string_view help;      ///< as the overlay shows it
  std::array<Key, 3> keys{};  ///< the defaults
};

/// The table, in the order of Action.
std::span<const ActionRow> actionTable();

/// Whether a model that is turned has this action, too: those of the picture and the window.
bool isOfModels(Action action);

/// Whether the key is Alt. While Alt is held, keys are for the desktop.
bool isAlt(Key key);

/// The keys of each action. Keys are places on the keyboard, whatever letters a layout has there.
/// No key has two actions.
class KeyMap {
 public:
  /// Has the default keys.
  KeyMap();

  std::optional<Action> actionOf(Key key) const;
  const std::vector<Key>& keysOf(Action action) const {
    return keys_[static_cast<std::size_t>(action)];
  }
  /// Gives an action these keys and no others. The keys lose all other actions.
  void bind(Action action, std::vector<Key> keys);

  friend bool operator==(const KeyMap&, const KeyMap&) = default;

 private:
  std::array<std::vector<Key>, kActionCount> keys_;
};

/// The keys of an action by their labels; `Shift` if both Shift keys are bound.
std::vector<std::string> shortNames(const KeyMap& keys, Action action);

struct KeyListRow {
  std::string names;
  std::string_view help;
};

/// The rows of the list on the screen and in `--help`, mouse and gamepad included.
std::vector<KeyListRow> keyList(const KeyMap& keys);

/// The same for a model that is turned.
std::vector<KeyListRow> modelKeyList(const KeyMap& keys);

/// A list as text, a line for each row.
std::string keyHelp(const std::vector<KeyListRow>& rows);
/// Both lists as text, each below its title.
std::string keyHelp(const KeyMap& keys);

}  // namespace hearth
