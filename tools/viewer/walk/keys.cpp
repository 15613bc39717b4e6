#include "viewer/walk/keys.h"

#include <SDL_keyboard.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace hearth {

namespace {

constexpr std::array kActions = {
    ActionRow{Action::Forward, "forward", "walk forward", {SDL_SCANCODE_W, SDL_SCANCODE_UP}},
    ActionRow{Action::Backward, "backward", "walk backward", {SDL_SCANCODE_S, SDL_SCANCODE_DOWN}},
    ActionRow{Action::StepLeft, "stepLeft", "step to the left", {SDL_SCANCODE_A}},
    ActionRow{Action::StepRight, "stepRight", "step to the right", {SDL_SCANCODE_D}},
    ActionRow{Action::TurnLeft, "turnLeft", "turn left", {SDL_SCANCODE_LEFT}},
    ActionRow{Action::TurnRight, "turnRight", "turn right", {SDL_SCANCODE_RIGHT}},
    ActionRow{Action::LookUp, "lookUp", "look up", {SDL_SCANCODE_PAGEUP}},
    ActionRow{Action::LookDown, "lookDown", "look down", {SDL_SCANCODE_PAGEDOWN}},
    ActionRow{Action::LookAhead,
              "lookAhead",
              "look straight ahead",
              {SDL_SCANCODE_HOME, SDL_SCANCODE_END}},
    ActionRow{Action::Run, "run", "run", {SDL_SCANCODE_LSHIFT, SDL_SCANCODE_RSHIFT}},
    ActionRow{Action::Jump, "jump", "jump, fly up", {SDL_SCANCODE_SPACE}},
    ActionRow{Action::Crouch,
              "crouch",
              "crouch, fly down",
              {SDL_SCANCODE_C, SDL_SCANCODE_LCTRL, SDL_SCANCODE_RCTRL}},
    ActionRow{Action::Fly, "fly", "fly, walk again", {SDL_SCANCODE_N}},
    ActionRow{Action::ShowBoth, "showBoth", "textures and light", {SDL_SCANCODE_1}},
    ActionRow{Action::ShowTextures, "showTextures", "textures alone", {SDL_SCANCODE_2}},
    ActionRow{Action::ShowLight, "showLight", "light alone", {SDL_SCANCODE_3}},
    ActionRow{Action::Map, "map", "map", {SDL_SCANCODE_TAB}},
    ActionRow{Action::ZoomIn, "zoomIn", "map larger", {SDL_SCANCODE_EQUALS, SDL_SCANCODE_KP_PLUS}},
    ActionRow{
        Action::ZoomOut, "zoomOut", "map smaller", {SDL_SCANCODE_MINUS, SDL_SCANCODE_KP_MINUS}},
    ActionRow{Action::Bookmark, "bookmark", "bookmark this place", {SDL_SCANCODE_B}},
    ActionRow{Action::NextBookmark, "nextBookmark", "go to the next bookmark", {SDL_SCANCODE_G}},
    ActionRow{Action::Overlay, "overlay", "overlay", {SDL_SCANCODE_F1}},
    ActionRow{Action::FullScreen, "fullScreen", "full screen", {SDL_SCANCODE_F11}},
    ActionRow{Action::Screenshot, "screenshot", "save the picture", {SDL_SCANCODE_F12}},
    ActionRow{Action::Keys, "keys", "list of keys", {SDL_SCANCODE_H}},
    ActionRow{Action::Leave, "leave", "free mouse, leave", {SDL_SCANCODE_ESCAPE}},
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
    ListedActions{Action::StepLeft, Action::StepRight, "step to the side"},
    ListedActions{Action::TurnLeft, Action::TurnRight, "turn"},
    ListedActions{Action::LookUp, Action::LookDown, "look up and down"},
    ListedActions{Action::LookAhead, Action::LookAhead, "look straight ahead"},
    ListedActions{Action::Run, Action::Run, "run"},
    ListedActions{Action::Jump, Action::Jump, "jump; in flight: up"},
    ListedActions{Action::Crouch, Action::Crouch, "crouch; in flight: down"},
    ListedActions{Action::Fly, Action::Fly, "fly, or walk again"},
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
    Listed{"A B Y, triggers", "jump, crouch, fly, run"},
};

/// Two keys that bear one name.
struct Twins {
  SDL_Scancode first;
  SDL_Scancode second;
  std::string_view name;
};
constexpr std::array kTwins = {
    Twins{SDL_SCANCODE_LSHIFT, SDL_SCANCODE_RSHIFT, "Shift"},
    Twins{SDL_SCANCODE_LCTRL, SDL_SCANCODE_RCTRL, "Ctrl"},
    Twins{SDL_SCANCODE_EQUALS, SDL_SCANCODE_KP_PLUS, "+"},
    Twins{SDL_SCANCODE_MINUS, SDL_SCANCODE_KP_MINUS, "-"},
};

bool has(const std::vector<SDL_Scancode>& keys, SDL_Scancode key) {
  return std::ranges::find(keys, key) != keys.end();
}

/// Beside the other keys of its action.
std::string shortName(SDL_Scancode key, const std::vector<SDL_Scancode>& beside) {
  for (const auto& [first, second, name] : kTwins)
    if ((key == first && has(beside, second)) || (key == second && has(beside, first)))
      return std::string(name);
  return key == SDL_SCANCODE_ESCAPE ? "Esc" : nameOf(key);
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

// --- Keys ----------------------------------------------------------------------------------------

std::string nameOf(SDL_Scancode key) { return SDL_GetScancodeName(key); }

std::optional<SDL_Scancode> keyNamed(std::string_view name) {
  const SDL_Scancode key = SDL_GetScancodeFromName(std::string(name).data());
  if (key == SDL_SCANCODE_UNKNOWN) return std::nullopt;
  return key;
}

std::vector<std::string_view> allKeyNames() {
  std::vector<std::string_view> names;
  for (int code = 0; code < SDL_NUM_SCANCODES; ++code)
    if (const std::string_view name = SDL_GetScancodeName(static_cast<SDL_Scancode>(code));
        !name.empty())
      names.push_back(name);
  return names;
}

bool isForTheDesktop(SDL_Scancode key) {
  return key == SDL_SCANCODE_LALT || key == SDL_SCANCODE_RALT;
}

// --- Which asks for what -------------------------------------------------------------------------

KeyMap::KeyMap() {
  for (const ActionRow& row : kActions)
    for (const SDL_Scancode key : row.keys)
      if (key != SDL_SCANCODE_UNKNOWN) keys_[static_cast<std::size_t>(row.action)].push_back(key);
}

std::optional<Action> KeyMap::actionOf(SDL_Scancode key) const {
  for (const ActionRow& row : kActions)
    if (has(keysOf(row.action), key)) return row.action;
  return std::nullopt;
}

void KeyMap::bind(Action action, std::vector<SDL_Scancode> keys) {
  for (std::vector<SDL_Scancode>& others : keys_)
    std::erase_if(others, [&keys](SDL_Scancode key) { return has(keys, key); });
  keys_[static_cast<std::size_t>(action)] = std::move(keys);
}

// --- Lists ---------------------------------------------------------------------------------------

std::vector<std::string> shortNames(const KeyMap& keys, Action action) {
  std::vector<std::string> names;
  for (const SDL_Scancode key : keys.keysOf(action)) {
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

std::string keyHelp(const KeyMap& keys) {
  std::string help;
  for (const KeyListRow& row : keyList(keys))
    fmt::format_to(std::back_inserter(help), "  {:<16}{}\n", row.names, row.help);
  return help;
}

}  // namespace hearth
