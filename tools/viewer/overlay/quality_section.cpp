#include "viewer/overlay/quality_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "settings/approximations.h"
#include "settings/measured_figures.h"
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

/// With two digits or, of large numbers, more.
std::string rounded(double number) {
  return number < 10 ? fmt::format("{:.2g}", number) : fmt::format("{:.0f}", number);
}

std::string errorInWords(const Figure& figure, Approximation::Of of) {
  return of == Approximation::Of::Bake
             ? fmt::format("{:g} levels off", figure.off)
             : fmt::format("{} % of pixels differ", rounded(100 * figure.off));
}

std::string words(const std::optional<Figure>& figure, Approximation::Of of) {
  if (!figure) return "not measured in this combination";
  return fmt::format("{} x the time, {}", rounded(figure->cost), errorInWords(*figure, of));
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

// --- Settings, one by one ------------------------------------------------------------------------

/// What holds without any option.
std::string standardOf(const Approximation& approximation, const QualityInLevel& inLevel) {
  return approximation.of == Approximation::Of::Bake
             ? valueOf(inLevel.ofLevel, approximation.setting)
             : valueOf(DrawSettings{}, approximation.setting);
}

/// What can be chosen: what is measured, the level's own and what holds now.
std::vector<std::string> valuesOf(const Approximation& approximation, const QualityInLevel& inLevel,
                                  const std::string& current) {
  std::vector<std::string> values;
  const auto add = [&values](const std::string& value) {
    if (std::ranges::find(values, value) == values.end()) values.push_back(value);
  };
  add(standardOf(approximation, inLevel));
  for (const std::string_view value : triedOf(approximation)) add(std::string(value));
  add(current);
  return values;
}

/// Of a value by itself, as short as its column; empty where it was not measured.
std::string figureWords(const Approximation& approximation, const QualityInLevel& inLevel,
                        const std::string& value) {
  const auto figure = figureOf(approximation.setting, value, standardOf(approximation, inLevel));
  if (!figure) return "";
  return fmt::format("{} x, {}", rounded(figure->cost), errorInWords(*figure, approximation.of));
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
      const std::string figure = figureWords(approximation, inLevel, value);
      const std::string label = figure.empty() ? value : fmt::format("{:<10}{}", value, figure);
      if (!ImGui::Selectable(label.data(), value == current)) continue;
      options.set(option, value);
      isChosen = true;
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  ImGui::TableNextColumn();
  showText(figureWords(approximation, inLevel, current));
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

std::string bakeInWords(const QualityInLevel& inLevel, const OptionValues& options) {
  if (options.has(Option::LightFrom)) return "from a file";
  if (inLevel.bake == inLevel.ofLevel) return "as the level says";
  return words(figureOf(inLevel.bake, inLevel.ofLevel), Approximation::Of::Bake);
}

std::string framesInWords(const QualityInLevel& inLevel) {
  return words(figureOf(inLevel.draw), Approximation::Of::Frame);
}

bool showQuality(const QualityInLevel& inLevel, QualityChoice& choice) {
  showSliders(choice);
  bool isChosen = showQualities(choice.options);
  showText("bake: " + bakeInWords(inLevel, choice.options));
  showText("frames: " + framesInWords(inLevel));
  isChosen |= showSettings(inLevel, choice.options);
  return isChosen;
}

}  // namespace hearth
