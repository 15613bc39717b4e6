#include "viewer/input/actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace hearth {

namespace {

constexpr std::array kActions = {
    ActionRow{Action::Forward, "forward", "walk forward", {Key::W, Key::Up}},
    ActionRow{Action::Backward, "backward", "walk backward", {Key::S, Key::Down}},
    ActionRow{Action::StrafeLeft, "stepLeft", "step to the left", {Key::A}},
    ActionRow{Action::StrafeRight, "stepRight", "step to the right", {Key::D}},
    ActionRow{Action::TurnLeft, "turnLeft", "turn left", {Key::Left}},
    ActionRow{Action::TurnRight, "turnRight", "turn right", {Key::Right}},
    ActionRow{Action::LookUp, "lookUp", "look up", {Key::PageUp}},
    ActionRow{Action::LookDown, "lookDown", "look down", {Key::PageDown}},
    ActionRow{Action::LookAhead, "lookAhead", "look straight ahead", {Key::Home, Key::End}},
    ActionRow{Action::Run, "run", "run", {Key::LeftShift, Key::RightShift}},
    ActionRow{Action::Jump, "jump", "jump, fly up", {Key::Space}},
    ActionRow{
        Action::Crouch, "crouch", "crouch, fly down", {Key::C, Key::LeftCtrl, Key::RightCtrl}},
    ActionRow{Action::Fly, "fly", "fly, walk again", {Key::N}},
    ActionRow{Action::Use, "use", "open, start, use", {Key::E}},
    ActionRow{Action::ShowBoth, "showBoth", "textures and light", {Key::Digit1}},
    ActionRow{Action::ShowTextures, "showTextures", "textures alone", {Key::Digit2}},
    ActionRow{Action::ShowLight, "showLight", "light alone", {Key::Digit3}},
    ActionRow{Action::Map, "map", "map", {Key::Tab}},
    ActionRow{Action::ZoomIn, "zoomIn", "map larger", {Key::Equals, Key::KeypadPlus}},
    ActionRow{Action::ZoomOut, "zoomOut", "map smaller", {Key::Minus, Key::KeypadMinus}},
    ActionRow{Action::Bookmark, "bookmark", "bookmark this place", {Key::B}},
    ActionRow{Action::NextBookmark, "nextBookmark", "go to the next bookmark", {Key::G}},
    ActionRow{Action::Overlay, "overlay", "overlay", {Key::F1}},
    ActionRow{Action::FullScreen, "fullScreen", "full screen", {Key::F11}},
    ActionRow{Action::Screenshot, "screenshot", "save the picture", {Key::F12}},
    ActionRow{Action::Keys, "keys", "list of keys", {Key::H}},
    ActionRow{Action::Leave, "leave", "free mouse, leave", {Key::Escape}},
};

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kActions.size(); ++i)
    if (static_cast<std::size_t>(kActions[i].action) != i) return false;
  return kActions.size() == kActionCount;
}
static_assert(isInOrder());

/// A row of the list: actions that follow one another, from `first` to `last`.
struct ListedActions {
  Action first;
  Action last;
  std::string_view help;
};
constexpr std::array kListed = {
    ListedActions{Action::Forward, Action::Backward, "walk"},
    ListedActions{Action::StrafeLeft, Action::StrafeRight, "step to the side"},
    ListedActions{Action::TurnLeft, Action::TurnRight, "turn"},
    ListedActions{Action::LookUp, Action::LookDown, "look up and down"},
    ListedActions{Action::LookAhead, Action::LookAhead, "look straight ahead"},
    ListedActions{Action::Run, Action::Run, "run"},
    ListedActions{Action::Jump, Action::Jump, "jump; in flight: up"},
    ListedActions{Action::Crouch, Action::Crouch, "crouch; in flight: down"},
    ListedActions{Action::Fly, Action::Fly, "fly, or walk again"},
    ListedActions{Action::Use, Action::Use, "open a door, start a lift"},
    ListedActions{Action::ShowBoth, Action::ShowLight, "textures and light, one alone"},
    ListedActions{Action::Map, Action::ZoomOut, "map of what was seen, its zoom"},
    ListedActions{Action::Bookmark, Action::NextBookmark, "bookmark here, go to the next"},
    ListedActions{Action::Overlay, Action::Overlay, "overlay: lights, why it is dark"},
    ListedActions{Action::FullScreen, Action::FullScreen, "full screen, or window again"},
    ListedActions{Action::Screenshot, Action::Screenshot, "save the picture as a PNG"},
    ListedActions{Action::Keys, Action::Keys, "show these keys"},
    ListedActions{Action::Leave, Action::Leave, "close overlay, free mouse, leave"},
};

struct Listed {
  std::string_view names;
  std::string_view help;
};
constexpr std::array kNoKeys = {
    Listed{"Mouse", "look, after a click"},
    Listed{"Gamepad", "left stick walks, right one looks"},
    Listed{"ABXY, triggers", "jump, crouch, use, fly, run"},
};

/// Of a model: keys that are the same for all users.
constexpr std::array kModelKeys = {
    Listed{"Left Right, A D", "turn the model"},
    Listed{"Up Down, E Q", "tilt the model"},
    Listed{"W S, + -", "nearer, farther"},
    Listed{"Home", "the whole model, from its front"},
};
constexpr std::array kModelMouse = {
    Listed{"Mouse", "a drag turns and tilts the model"},
    Listed{"Wheel", "nearer, farther"},
};

/// Two keys that bear one name.
struct Twins {
  Key first;
  Key second;
  std::string_view name;
};
constexpr std::array kTwins = {
    Twins{Key::LeftShift, Key::RightShift, "Shift"},
    Twins{Key::LeftCtrl, Key::RightCtrl, "Ctrl"},
    Twins{Key::Equals, Key::KeypadPlus, "+"},
    Twins{Key::Minus, Key::KeypadMinus, "-"},
};

bool has(const std::vector<Key>& keys, Key key) {
  return std::ranges::find(keys, key) != keys.end();
}

/// Beside the other keys of its action.
std::string shortName(Key key, const std::vector<Key>& beside) {
  for (const auto& [first, second, name] : kTwins)
    if ((key == first && has(beside, second)) || (key == second && has(beside, first)))
      return std::string(name);
  return key == Key::Escape ? "Esc" : nameOf(key);
}

/// The first keys of all actions of a row, then the second ones, as in `W S, Up Down`.
std::string namesOf(const KeyMap& keys, const ListedActions& row) {
  std::vector<std::string> ranks;
  for (auto i = static_cast<std::size_t>(row.first); i <= static_cast<std::size_t>(row.last); ++i) {
    const std::vector<std::string> names = shortNames(keys, static_cast<Action>(i));
    if (names.size() > ranks.size()) ranks.resize(names.size());
    for (std::size_t rank = 0; rank < names.size(); ++rank)
      ranks[rank] += (ranks[rank].empty() ? "" : " ") + names[rank];
  }
  if (ranks.empty()) return "no key";
  std::string all = ranks.front();
  for (std::size_t rank = 1; rank < ranks.size(); ++rank) all += ", " + ranks[rank];
  return all;
}

}  // namespace

std::span<const ActionRow> actionTable() { return kActions; }

bool isOfModels(Action action) {
  switch (action) {
    case Action::ShowBoth:
    case Action::ShowTextures:
    case Action::ShowLight:
    case Action::Overlay:
    case Action::FullScreen:
    case Action::Screenshot:
    case Action::Keys:
    case Action::Leave:
      return true;
    default:
      return false;
  }
}

bool isAlt(Key key) { return key == Key::LeftAlt || key == Key::RightAlt; }

// --- Which asks for what -------------------------------------------------------------------------

KeyMap::KeyMap() {
  for (const ActionRow& row : kActions)
    for (const Key key : row.keys)
      if (key != Key::None) keys_[static_cast<std::size_t>(row.action)].push_back(key);
}

std::optional<Action> KeyMap::actionOf(Key key) const {
  for (const ActionRow& row : kActions)
    if (has(keysOf(row.action), key)) return row.action;
  return std::nullopt;
}

void KeyMap::bind(Action action, std::vector<Key> keys) {
  for (std::vector<Key>& others : keys_)
    std::erase_if(others, [&keys](Key key) { return has(keys, key); });
  keys_[static_cast<std::size_t>(action)] = std::move(keys);
}

// --- Lists ---------------------------------------------------------------------------------------

std::vector<std::string> shortNames(const KeyMap& keys, Action action) {
  std::vector<std::string> names;
  for (const Key key : keys.keysOf(action)) {
    std::string name = shortName(key, keys.keysOf(action));
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

std::vector<KeyListRow> keyList(const KeyMap& keys) {
  std::vector<KeyListRow> rows;
  for (const ListedActions& row : kListed) rows.push_back({namesOf(keys, row), row.help});
  for (const Listed& row : kNoKeys) rows.push_back({std::string(row.names), row.help});
  return rows;
}

std::vector<KeyListRow> modelKeyList(const KeyMap& keys) {
  std::vector<KeyListRow> rows;
  for (const Listed& row : kModelKeys) rows.push_back({std::string(row.names), row.help});
  for (const ListedActions& row : kListed)
    if (isOfModels(row.first)) rows.push_back({namesOf(keys, row), row.help});
  for (const Listed& row : kModelMouse) rows.push_back({std::string(row.names), row.help});
  return rows;
}

std::string keyHelp(const std::vector<KeyListRow>& rows) {
  std::string help;
  for (const KeyListRow& row : rows)
    fmt::format_to(std::back_inserter(help), "  {:<16}{}\n", row.names, row.help);
  return help;
}

std::string keyHelp(const KeyMap& keys) {
  return "Keys:\n" + keyHelp(keyList(keys)) + "Keys with a model:\n" + keyHelp(modelKeyList(keys));
}

}  // namespace hearth
