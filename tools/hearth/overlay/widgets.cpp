#include "hearth/overlay/widgets.h"

#include <imgui/imgui.h>

#include <cmath>

namespace hearth {

namespace {

// In letters.
constexpr float kTipWidth = 50;
constexpr float kSliderName = 16;
constexpr float kSliderWidth = 24;

}  // namespace

float letters(float count) { return count * ImGui::CalcTextSize("M").x; }

void showText(const std::string& text) { ImGui::TextUnformatted(text.data()); }

void showWrapped(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  showText(text);
  ImGui::PopTextWrapPos();
}

void showTip(const std::string& text) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(letters(kTipWidth));
  showText(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool showSlider(const char* name, double& value, const SliderRange& range,
                const std::string& words) {
  ImGui::AlignTextToFramePadding();
  showText(name);
  ImGui::SameLine(letters(kSliderName));
  ImGui::SetNextItemWidth(letters(kSliderWidth));
  auto shown = static_cast<float>(value);
  ImGui::PushID(name);
  const bool isMoved =
      ImGui::SliderFloat("##slider", &shown, static_cast<float>(range.least),
                         static_cast<float>(range.most), "", ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopID();
  showTip("Ctrl and a click let you type a number.");
  ImGui::SameLine();
  showText(words);
  if (isMoved) value = std::round(shown * range.steps) / range.steps;
  return isMoved;
}

}  // namespace hearth
