#include "viewer/overlay/widgets.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>

namespace hearth {

namespace {

// In letters.
constexpr float kTipWidth = 50;
constexpr float kSliderName = 16;
constexpr float kSliderWidth = 24;

float widthOf(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

/// The bytes of the first line: up to the last blank that leaves it narrow enough, else the first.
std::size_t firstLine(std::string_view text, float width) {
  std::size_t end = std::min(text.find(' '), text.size());
  while (end < text.size()) {
    const std::size_t next = std::min(text.find(' ', end + 1), text.size());
    if (widthOf(text.substr(0, next)) > width) break;
    end = next;
  }
  return end;
}

}  // namespace

float letters(float count) { return count * ImGui::CalcTextSize("M").x; }

void showText(const std::string& text) { ImGui::TextUnformatted(text.data()); }

std::string brokenAtBlanks(std::string_view text, float width) {
  std::string lines;
  while (true) {
    const std::size_t end = firstLine(text, width);
    lines += text.substr(0, end);
    if (end == text.size()) return lines;
    lines += '\n';
    text.remove_prefix(end + 1);
  }
}

void showWrapped(std::string_view text) {
  const std::string lines = brokenAtBlanks(text, ImGui::GetContentRegionAvail().x);
  ImGui::TextUnformatted(lines.data(), lines.data() + lines.size());
}

void showTip(const std::string& text) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const std::string lines = brokenAtBlanks(text, letters(kTipWidth));
  const float width = ImGui::CalcTextSize(lines.data()).x + 2 * ImGui::GetStyle().WindowPadding.x;
  // Beside the panel, where there is room: on it tips would cover what they are about.
  const float left = ImGui::GetWindowPos().x - ImGui::GetStyle().WindowPadding.x;
  if (left >= width) ImGui::SetNextWindowPos({left, ImGui::GetMousePos().y}, 0, {1, 0});
  ImGui::BeginTooltip();
  showText(lines);
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
