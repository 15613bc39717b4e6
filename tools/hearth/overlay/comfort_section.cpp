#include "hearth/overlay/comfort_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <vector>

#include "hearth/overlay/widgets.h"

namespace hearth {

namespace {

/// Degrees a pixel, to more than hands like; so the slider is fine enough.
constexpr SliderRange kMouse{kLeastDegreesPerPixel, 1, 100};
constexpr SliderRange kBob{0, 1, 100};

const ActionRow& rowOf(Action action) { return actionTable()[static_cast<std::size_t>(action)]; }

}  // namespace

bool ComfortSection::take(const SDL_Event& event, Comfort& comfort) {
  if (!asked_ || event.type != SDL_KEYDOWN) return false;
  const SDL_Scancode key = event.key.keysym.scancode;
  if (key != SDL_SCANCODE_ESCAPE && !isForTheDesktop(key)) give(key, comfort);
  asked_.reset();
  return true;
}

void ComfortSection::give(SDL_Scancode key, Comfort& comfort) {
  const auto loser = comfort.keys.actionOf(key);
  told_ = loser && *loser != asked_->action
              ? fmt::format("{} was a key of \"{}\"", nameOf(key), rowOf(*loser).help)
              : "";
  std::vector<SDL_Scancode> keys = comfort.keys.keysOf(asked_->action);
  std::erase(keys, key);
  const auto place = asked_->replaced ? std::ranges::find(keys, *asked_->replaced) : keys.end();
  if (place != keys.end())
    *place = key;
  else
    keys.push_back(key);
  comfort.keys.bind(asked_->action, std::move(keys));
  isChanged_ = true;
}

bool ComfortSection::show(Comfort& comfort) {
  isChanged_ |= showSlider("mouse", comfort.degreesPerPixel, kMouse,
                           fmt::format("{:.2f} degrees a pixel", comfort.degreesPerPixel));
  isChanged_ |= showSlider("view bob", comfort.viewBob, kBob,
                           fmt::format("{:.0f} % with each step", 100 * comfort.viewBob));
  isChanged_ |= ImGui::Checkbox("the mouse looks up when it is drawn near", &comfort.invertsPitch);
  showKeys(comfort);
  const bool canBeWritten = isChanged_ && !ImGui::IsAnyItemActive();
  if (canBeWritten) isChanged_ = false;
  return canBeWritten;
}

void ComfortSection::showKeys(Comfort& comfort) {
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
    showKeysOf(row.action, comfort);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

void ComfortSection::showKeysOf(Action action, Comfort& comfort) {
  std::vector<SDL_Scancode> kept = comfort.keys.keysOf(action);
  for (const SDL_Scancode key : comfort.keys.keysOf(action)) {
    if (ImGui::SmallButton(nameOf(key).data())) asked_ = Asked{action, key};
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) std::erase(kept, key);
    ImGui::SameLine();
  }
  ImGui::PushID("more");  // than a key that is called so
  if (ImGui::SmallButton("+")) asked_ = Asked{action, std::nullopt};
  ImGui::PopID();
  if (kept == comfort.keys.keysOf(action)) return;
  comfort.keys.bind(action, std::move(kept));
  isChanged_ = true;
}

}  // namespace hearth
