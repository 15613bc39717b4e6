#include "hearth/overlay/comfort_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hearth {

namespace {

/// More than hands like, so that the slider is fine enough.
constexpr double kMostDegreesOfSlider = 1;
constexpr double kPercent = 100;

const ActionRow& rowOf(Action action) { return actionTable()[static_cast<std::size_t>(action)]; }

/// A value that shows `scale` times as large, and is chosen in steps of `step` of that.
bool showSlider(const char* name, double& value, double scale, double step, double least,
                double most, const char* format) {
  auto shown = static_cast<float>(scale * value);
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::SliderFloat(name, &shown, static_cast<float>(least), static_cast<float>(most), format,
                          ImGuiSliderFlags_AlwaysClamp))
    return false;
  value = std::round(shown / step) * step / scale;
  return true;
}

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
  if (ImGui::CollapsingHeader("Comfort")) {
    isChanged_ |=
        showSlider("##mouse", comfort.degreesPerPixel, 1, kLeastDegreesPerPixel,
                   kLeastDegreesPerPixel, kMostDegreesOfSlider, "mouse %.2f degrees a pixel");
    isChanged_ |= showSlider("##bob", comfort.viewBob, kPercent, 1, 0, kPercent,
                             "steps move the view by %.0f %%");
    isChanged_ |=
        ImGui::Checkbox("the mouse looks up when it is drawn near", &comfort.invertsPitch);
    showKeys(comfort);
  }
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
