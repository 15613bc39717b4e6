#include "viewer/overlay/preferences_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <vector>

#include "viewer/overlay/widgets.h"

namespace hearth {

namespace {

/// Degrees a pixel, to more than hands like; so the slider is fine enough.
constexpr SliderRange kMouseRange{kLeastDegreesPerPixel, 1, 100};
constexpr SliderRange kBob{0, 1, 100};

const ActionRow& rowOf(Action action) { return actionTable()[static_cast<std::size_t>(action)]; }

}  // namespace

bool PreferencesSection::handle(const Event& event, Preferences& preferences) {
  const auto* pressed = std::get_if<KeyEvent>(&event);
  if (!asked_ || !pressed || !pressed->isDown) return false;
  const Key key = pressed->key;
  if (key != Key::Escape && !isAlt(key)) give(key, preferences);
  asked_.reset();
  return true;
}

void PreferencesSection::give(Key key, Preferences& preferences) {
  const auto loser = preferences.keys.actionOf(key);
  told_ = loser && *loser != asked_->action
              ? fmt::format("{} was a key of \"{}\"", nameOf(key), rowOf(*loser).help)
              : "";
  std::vector<Key> keys = preferences.keys.keysOf(asked_->action);
  std::erase(keys, key);
  const auto place = asked_->replaced ? std::ranges::find(keys, *asked_->replaced) : keys.end();
  if (place != keys.end())
    *place = key;
  else
    keys.push_back(key);
  preferences.keys.bind(asked_->action, std::move(keys));
  isChanged_ = true;
}

bool PreferencesSection::show(Preferences& preferences) {
  isChanged_ |= showSlider("mouse", preferences.degreesPerPixel, kMouseRange,
                           fmt::format("{:.2f} degrees a pixel", preferences.degreesPerPixel));
  isChanged_ |= showSlider("view bob", preferences.viewBob, kBob,
                           fmt::format("{:.0f} % with each step", 100 * preferences.viewBob));
  isChanged_ |=
      ImGui::Checkbox("the mouse looks up when it is drawn near", &preferences.invertsPitch);
  showKeys(preferences);
  const bool canBeWritten = isChanged_ && !ImGui::IsAnyItemActive();
  if (canBeWritten) isChanged_ = false;
  return canBeWritten;
}

void PreferencesSection::showKeys(Preferences& preferences) {
  const std::string hint =
      asked_          ? fmt::format("press a key for \"{}\", or Esc", rowOf(asked_->action).help)
      : told_.empty() ? "click a key to change it, + adds one, a right click removes"
                      : told_;
  ImGui::TextWrapped("%s", hint.data());
  if (!ImGui::BeginTable("keys", 2)) return;
  for (const ActionRow& row : actionTable()) {
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.help.data());
    ImGui::TableNextColumn();
    ImGui::PushID(row.name.data());
    showKeysOf(row.action, preferences);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

void PreferencesSection::showKeysOf(Action action, Preferences& preferences) {
  std::vector<Key> kept = preferences.keys.keysOf(action);
  for (const Key key : preferences.keys.keysOf(action)) {
    if (ImGui::SmallButton(nameOf(key).data())) asked_ = Asked{action, key};
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) std::erase(kept, key);
    ImGui::SameLine();
  }
  ImGui::PushID("more");  // than a key that is called so
  if (ImGui::SmallButton("+")) asked_ = Asked{action, std::nullopt};
  ImGui::PopID();
  if (kept == preferences.keys.keysOf(action)) return;
  preferences.keys.bind(action, std::move(kept));
  isChanged_ = true;
}

}  // namespace hearth
