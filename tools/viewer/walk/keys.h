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

/// What a key or a button asks for.
enum class Action : std::uint8_t {
  Forward,
  Backward,
  StepLeft,
  StepRight,
  TurnLeft,
  TurnRight,
  LookUp,
  LookDown,
  LookAhead,
  Run,
  Jump,
  Crouch,
  Fly,
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

/// A row of the table that input, the user's settings and lists of keys are made from.
struct ActionRow {
  Action action{};
  std::string_view name;      ///< in files
  std::string_view help;      ///< in the overlay
  std::array<Key, 3> keys{};  ///< unless the user says otherwise
};

/// By Action.
std::span<const ActionRow> actionTable();

/// With Alt held, keys are for the desktop.
bool isForTheDesktop(Key key);

/// Which key asks for what. Keys are places on the keyboard: they keep theirs where letters lie
/// otherwise. None has two actions.
class KeyMap {
 public:
  /// Those of the table.
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

/// The keys of an action as they are written on them: `Shift` where both ask for the same.
std::vector<std::string> shortNames(const KeyMap& keys, Action action);

struct KeyListRow {
  std::string names;
  std::string_view help;
};

/// What the list on the screen and `--help` show, mouse and gamepad included.
std::vector<KeyListRow> keyList(const KeyMap& keys);

/// The list as text, a line for each row.
std::string keyHelp(const KeyMap& keys);

}  // namespace hearth
