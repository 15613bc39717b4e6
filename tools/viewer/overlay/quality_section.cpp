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

/// Degrees; beyond these the picture is hard to read.
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
  return of == Approximation::Of::Frame
             ? fmt::format("{} % of pixels differ", rounded(100 * figure.off))
             : fmt::format("{:g} levels off", figure.off);
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
  const std::string_view current = qualityFrom(options).name;
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

/// Of the settings that a setting is one of.
std::string valueIn(const BakeSettings& bake, const DrawSettings& draw,
                    const MoverLightSettings& movers, const Approximation& approximation) {
  switch (approximation.of) {
    case Approximation::Of::Bake:
      return valueOf(bake, approximation.setting);
    case Approximation::Of::Frame:
      return valueOf(draw, approximation.setting);
    case Approximation::Of::Movers:
      return valueOf(movers, approximation.setting);
  }
  return "";
}

/// What holds without any option.
std::string standardOf(const Approximation& approximation, const EffectiveSettings& effective) {
  return valueIn(effective.authored, {}, {}, approximation);
}

/// What can be chosen: what is measured, the level's own and what holds now.
std::vector<std::string> valuesOf(const Approximation& approximation,
                                  const EffectiveSettings& effective, const std::string& current) {
  std::vector<std::string> values;
  const auto add = [&values](const std::string& value) {
    if (std::ranges::find(values, value) == values.end()) values.push_back(value);
  };
  add(standardOf(approximation, effective));
  for (const std::string_view value : triedOf(approximation)) add(std::string(value));
  add(current);
  return values;
}

/// Of a value by itself, as short as its column; empty where it was not measured.
std::string figureWords(const Approximation& approximation, const EffectiveSettings& effective,
                        const std::string& value) {
  const auto figure = figureOf(approximation.setting, value, standardOf(approximation, effective));
  if (!figure) return "";
  return fmt::format("{} x, {}", rounded(figure->cost), errorInWords(*figure, approximation.of));
}

void showBound(const Approximation& approximation) {
  showTip(fmt::format("How far off: {} ({}).", approximation.bound, approximation.code));
}

/// The list of values. Returns the one that was chosen, if any.
std::optional<std::string> showValues(const Approximation& approximation,
                                      const EffectiveSettings& effective,
                                      const std::string& current) {
  const std::string id = fmt::format("##{}", settingNameOf(approximation.setting));
  if (!ImGui::BeginCombo(id.data(), current.data())) {
    showBound(approximation);
    return std::nullopt;
  }
  std::optional<std::string> chosen;
  for (const std::string& value : valuesOf(approximation, effective, current)) {
    const std::string figure = figureWords(approximation, effective, value);
    const std::string label = figure.empty() ? value : fmt::format("{:<10}{}", value, figure);
    if (ImGui::Selectable(label.data(), value == current)) chosen = value;
  }
  ImGui::EndCombo();
  return chosen;
}

bool showSetting(const Approximation& approximation, const EffectiveSettings& effective,
                 OptionValues& options) {
  const Option option = approximation.setting;
  const bool needsBake = approximation.of != Approximation::Of::Frame;
  const std::string current =
      valueIn(effective.bake, effective.draw, effective.movers, approximation);
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  showText(settingNameOf(option));
  showBound(approximation);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  ImGui::BeginDisabled(needsBake && !effective.canBake);
  const std::optional<std::string> chosen = showValues(approximation, effective, current);
  ImGui::EndDisabled();
  ImGui::TableNextColumn();
  showText(figureWords(approximation, effective, current));
  if (chosen) options.set(option, *chosen);
  return chosen.has_value();
}

bool showSettings(const EffectiveSettings& effective, OptionValues& options) {
  if (!ImGui::BeginTable("settings", 3)) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, letters(kSettingNameWidth));
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, letters(kValueWidth));
  ImGui::TableSetupColumn("figure");
  bool isChosen = false;
  for (const Approximation& approximation : approximations())
    isChosen |= showSetting(approximation, effective, options);
  ImGui::EndTable();
  return isChosen;
}

// --- View ----------------------------------------------------------------------------------------

void showSliders(QualityChoice& choice) {
  showSlider("field of view", choice.fov, kFov, fmt::format("{:.0f} degrees", choice.fov));
  showSlider("frame cap", choice.frameCap, kFrames,
             choice.frameCap > 0 ? fmt::format("{:.0f} a second", choice.frameCap) : "no limit");
}

}  // namespace

void chooseQuality(OptionValues& options, std::string_view name) {
  for (const Approximation& approximation : approximations()) options.unset(approximation.setting);
  options.set(Option::Quality, std::string(name));
}

std::string bakeInWords(const EffectiveSettings& effective, const OptionValues& options) {
  if (options.has(Option::LightFrom)) return "from a file";
  if (effective.bake == effective.authored) return "as the level says";
  return words(figureOf(effective.bake, effective.authored), Approximation::Of::Bake);
}

std::string framesInWords(const EffectiveSettings& effective) {
  return words(figureOf(effective.draw), Approximation::Of::Frame);
}

bool showQuality(const EffectiveSettings& effective, QualityChoice& choice) {
  showSliders(choice);
  bool isChosen = showQualities(choice.options);
  showText("bake: " + bakeInWords(effective, choice.options));
  showText("frames: " + framesInWords(effective));
  isChosen |= showSettings(effective, choice.options);
  return isChosen;
}

}  // namespace hearth
