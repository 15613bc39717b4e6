#include "viewer/overlay/quality_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "settings/approximations.h"
#include "settings/measured_pareto_front.h"
#include "settings/measured_settings.h"
#include "settings/quality.h"
#include "settings/settings.h"
#include "viewer/overlay/widgets.h"

namespace hearth {

namespace {

/// Degrees that are looked through without straining.
constexpr SliderRange kFov{10, 170, 1};

/// More than displays show, so that the slider is fine enough.
constexpr SliderRange kFrames{0, 240, 1};

// In letters.
constexpr float kSettingNameWidth = 16;
constexpr float kValueWidth = 13;

std::string settingNameOf(Option option) { return std::string(row(option).name.substr(2)); }

std::string wordsOfFrame(double cost, double over2) {
  return fmt::format("{:g} x the time, {:.2g} % off", cost, 100 * over2);
}

std::string wordsOfBake(double cost, double rms) {
  return fmt::format("{:g} x the time, {:g} levels off", cost, rms);
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
  return found == measuredBakes().end() ? "not measured in this combination"
                                        : wordsOfBake(found->cost, found->rms);
}

std::string figureOf(const DrawSettings& draw) {
  const auto found = std::ranges::find(measuredFrames(), draw, &MeasuredFrame::draw);
  return found == measuredFrames().end() ? "not measured in this combination"
                                         : wordsOfFrame(found->cost, found->over2);
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

/// Of a value by itself, all others as they are by default; empty where it was not measured.
std::string figureOf(const Approximation& approximation, const std::string& value) {
  const MeasuredSetting* found = measuredAlone(approximation.setting, value);
  if (!found) return "";
  return approximation.of == Approximation::Of::Bake ? wordsOfBake(found->cost, found->off)
                                                     : wordsOfFrame(found->cost, found->off);
}

void showBound(const Approximation& approximation) {
  showTip(fmt::format("How far off: {} ({}).", approximation.bound, approximation.code));
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
  showText(settingNameOf(option));
  showBound(approximation);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  ImGui::BeginDisabled(isOfBake && !inLevel.canBake);
  const bool isListOpen =
      ImGui::BeginCombo(fmt::format("##{}", settingNameOf(option)).data(), current.data());
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
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, letters(kSettingNameWidth));
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, letters(kValueWidth));
  ImGui::TableSetupColumn("figure");
  bool isChosen = false;
  for (const Approximation& approximation : approximations())
    isChosen |= showSetting(approximation, inLevel, options);
  ImGui::EndTable();
  return isChosen;
}

// --- View ----------------------------------------------------------------------------------------

void showSliders(QualityChoice& choice) {
  showSlider("field of view", choice.fov, kFov, fmt::format("{:.0f} degrees", choice.fov));
  showSlider("most frames", choice.frameCap, kFrames,
             choice.frameCap > 0 ? fmt::format("{:.0f} a second", choice.frameCap) : "no limit");
}

}  // namespace

void chooseQuality(OptionValues& options, std::string_view name) {
  for (const Approximation& approximation : approximations()) options.unset(approximation.setting);
  options.set(Option::Quality, std::string(name));
}

bool showQuality(const QualityInLevel& inLevel, QualityChoice& choice) {
  showSliders(choice);
  bool isChosen = showQualities(choice.options);
  showText("bake: " + figureOf(inLevel.bake, inLevel.ofLevel));
  showText("frames: " + figureOf(inLevel.draw));
  isChosen |= showSettings(inLevel, choice.options);
  return isChosen;
}

}  // namespace hearth
