#include "hearth/overlay/quality_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "hearth/quality.h"
#include "hearth/settings.h"
#include "hearth/tradeoff/approximations.h"
#include "hearth/tradeoff/measured_front.h"

namespace hearth {

namespace {

/// Degrees that are looked through without straining.
constexpr float kLeastFov = 10;
constexpr float kMostFov = 170;

/// More than displays show, so that the slider is fine enough.
constexpr float kMostFrames = 240;

// In letters.
constexpr float kNameWidth = 16;
constexpr float kValueWidth = 13;
constexpr float kBoundWidth = 50;

float letters(float count) { return count * ImGui::CalcTextSize("M").x; }

void showText(const std::string& text) { ImGui::TextUnformatted(text.data()); }

std::string nameOf(Option option) { return std::string(row(option).name.substr(2)); }

std::string words(const MeasuredFrame& frame) {
  return fmt::format("{:g} x the time, {:.2g} % off", frame.cost, 100 * frame.over2);
}

std::string words(const MeasuredBake& bake) {
  return fmt::format("{:g} x the time, {:g} levels off", bake.cost, bake.rms);
}

// --- Qualities -----------------------------------------------------------------------------------

bool hasSingleSettings(const OptionValues& options) {
  return std::ranges::any_of(approximations(), [&options](const Approximation& approximation) {
    return options.has(approximation.setting);
  });
}

bool showQualities(OptionValues& options) {
  bool isChosen = false;
  const std::string current = options.text(Option::Quality).value_or("normal");
  for (const Quality& quality : qualities()) {
    const bool isCurrent = current == quality.name && !hasSingleSettings(options);
    if (ImGui::RadioButton(std::string(quality.name).data(), isCurrent)) {
      chooseQuality(options, quality.name);
      isChosen = true;
    }
    ImGui::SameLine();
  }
  ImGui::NewLine();
  return isChosen;
}

/// What a bake by these settings was measured to cost and to miss.
std::string figureOf(const BakeSettings& bake, const BakeSettings& ofLevel) {
  if (bake == ofLevel) return "as the level says";
  const auto found = std::ranges::find_if(measuredBakes(), [&](const MeasuredBake& measured) {
    return measured.bake.of(ofLevel) == bake;
  });
  return found == measuredBakes().end() ? "not measured in this combination" : words(*found);
}

std::string figureOf(const DrawSettings& draw) {
  const auto found = std::ranges::find(measuredFrames(), draw, &MeasuredFrame::draw);
  return found == measuredFrames().end() ? "not measured in this combination" : words(*found);
}

// --- Settings, one by one ------------------------------------------------------------------------

/// What can be chosen: what is measured, the level's own and what holds now.
std::vector<std::string> valuesOf(const Approximation& approximation, const QualityInLevel& inLevel,
                                  const std::string& current) {
  std::vector<std::string> values;
  const auto add = [&values](const std::string& value) {
    if (std::ranges::find(values, value) == values.end()) values.push_back(value);
  };
  const Option option = approximation.setting;
  add(approximation.of == Approximation::Of::Bake ? valueOf(inLevel.ofLevel, option)
                                                  : valueOf(DrawSettings{}, option));
  for (const std::string_view value : triedOf(approximation)) add(std::string(value));
  add(current);
  return values;
}

/// Of a value by itself, where all others are exact; empty where it was not measured.
std::string figureOf(const Approximation& approximation, const std::string& value) {
  OptionValues alone;
  if (approximation.of == Approximation::Of::Frame) alone.set(approximation.setting, value);
  const DrawSettings draw = drawSettingsFrom(alone);
  const auto found = std::ranges::find(measuredFrames(), draw, &MeasuredFrame::draw);
  return found == measuredFrames().end() || draw == DrawSettings{} ? "" : words(*found);
}

void showBound(const Approximation& approximation) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(letters(kBoundWidth));
  showText(fmt::format("How far off: {} ({}).", approximation.bound, approximation.code));
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool showSetting(const Approximation& approximation, const QualityInLevel& inLevel,
                 OptionValues& options) {
  const Option option = approximation.setting;
  const bool isOfBake = approximation.of == Approximation::Of::Bake;
  const std::string current =
      isOfBake ? valueOf(inLevel.bake, option) : valueOf(inLevel.draw, option);
  bool isChosen = false;
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  showText(nameOf(option));
  showBound(approximation);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  ImGui::BeginDisabled(isOfBake && !inLevel.canBake);
  const bool isListOpen =
      ImGui::BeginCombo(fmt::format("##{}", nameOf(option)).data(), current.data());
  if (!isListOpen) showBound(approximation);
  if (isListOpen) {
    for (const std::string& value : valuesOf(approximation, inLevel, current)) {
      const std::string figure = figureOf(approximation, value);
      const std::string label = figure.empty() ? value : fmt::format("{:<10}{}", value, figure);
      if (!ImGui::Selectable(label.data(), value == current)) continue;
      options.set(option, value);
      isChosen = true;
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  ImGui::TableNextColumn();
  showText(figureOf(approximation, current));
  return isChosen;
}

bool showSettings(const QualityInLevel& inLevel, OptionValues& options) {
  if (!ImGui::BeginTable("settings", 3)) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, letters(kNameWidth));
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, letters(kValueWidth));
  ImGui::TableSetupColumn("figure");
  bool isChosen = false;
  for (const Approximation& approximation : approximations())
    isChosen |= showSetting(approximation, inLevel, options);
  ImGui::EndTable();
  return isChosen;
}

// --- View ----------------------------------------------------------------------------------------

void showSlider(const char* name, double& value, float least, float most, const char* format) {
  auto shown = static_cast<float>(value);
  if (ImGui::SliderFloat(name, &shown, least, most, format, ImGuiSliderFlags_AlwaysClamp))
    value = std::round(shown);
}

/// Both in a row.
void showSliders(QualityChoice& choice) {
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::PushItemWidth(std::floor((ImGui::GetContentRegionAvail().x - gap) / 2));
  showSlider("##fov", choice.fov, kLeastFov, kMostFov, "field of view %.0f degrees");
  ImGui::SameLine(0, gap);
  showSlider("##cap", choice.frameCap, 0, kMostFrames,
             choice.frameCap > 0 ? "at most %.0f frames/s" : "no cap on frames");
  ImGui::PopItemWidth();
}

}  // namespace

void chooseQuality(OptionValues& options, std::string_view name) {
  for (const Approximation& approximation : approximations()) options.unset(approximation.setting);
  options.set(Option::Quality, std::string(name));
}

bool showQuality(const QualityInLevel& inLevel, QualityChoice& choice) {
  if (!ImGui::CollapsingHeader("Quality", ImGuiTreeNodeFlags_DefaultOpen)) return false;
  showSliders(choice);
  bool isChosen = showQualities(choice.options);
  showText("bake: " + figureOf(inLevel.bake, inLevel.ofLevel));
  showText("frames: " + figureOf(inLevel.draw));
  isChosen |= showSettings(inLevel, choice.options);
  return isChosen;
}

}  // namespace hearth
