#include "hearth/overlay/lights_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace hearth {

namespace {

constexpr int kRows = 6;           // of the list that show at once
constexpr float kNameWidth = 11;   // of a field, in letters
constexpr double kLargest = 1e9;   // of all fields; the loader takes no more
constexpr double kLeast = 0;       // of all fields but the position
constexpr double kNoLeast = -1e9;  // of that one
constexpr const char* kMetres = "%.3f m";

/// How far a field goes for each pixel of the mouse.
constexpr float kMetresPerPixel = 0.01F;
constexpr float kLevelsPerPixel = 1;
constexpr float kFalloffPerPixel = 0.005F;

float letters(float count) { return count * ImGui::CalcTextSize("M").x; }

void showText(const std::string& text) { ImGui::TextUnformatted(text.data()); }

void showWrapped(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  showText(text);
  ImGui::PopTextWrapPos();
}

bool showButton(const char* name, bool isEnabled) {
  ImGui::BeginDisabled(!isEnabled);
  const bool isPressed = ImGui::Button(name);
  ImGui::EndDisabled();
  ImGui::SameLine();
  return isPressed;
}

void showButtons(LightsTool& tool, const Level& level, const Camera& camera) {
  LightsEditor& editor = tool.editor();
  if (showButton("add", true)) tool.addBefore(level, camera);
  if (showButton("delete", editor.picked().has_value())) {
    tool.release();
    editor.removePicked();
  }
  if (showButton("undo", editor.canUndo())) editor.undo();
  if (showButton("redo", editor.canRedo())) editor.redo();
  if (showButton("save", editor.isUnsaved())) {
    tool.release();
    editor.save();
  }
  showText(editor.isUnsaved() ? "not saved" : "");
}

// --- The list ------------------------------------------------------------------------------------

ImVec4 swatchOf(const LightSource& light) {
  return {static_cast<float>(light.share(0)), static_cast<float>(light.share(1)),
          static_cast<float>(light.share(2)), 1};
}

void showRow(LightsTool& tool, std::size_t i) {
  LightsEditor& editor = tool.editor();
  const float height = ImGui::GetTextLineHeight();
  ImGui::PushID(static_cast<int>(i));
  ImGui::ColorButton("##color", swatchOf(editor.lights().lights[i].source),
                     ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                     {height, height});
  ImGui::SameLine();
  const std::string name = fmt::format("{} {}", i, editor.commentOf(i));
  if (ImGui::Selectable(name.data(), editor.picked() == i)) {
    tool.release();
    editor.pick(i);
  }
  ImGui::PopID();
}

void showList(LightsTool& tool, bool scrollsToPicked) {
  LightsEditor& editor = tool.editor();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  if (ImGui::BeginChild("list", {0, kRows * line + 2 * ImGui::GetStyle().WindowPadding.y}, true)) {
    if (scrollsToPicked)
      ImGui::SetScrollY(line * static_cast<float>(*editor.picked()) +
                        ImGui::GetStyle().WindowPadding.y);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(editor.lights().lights.size()));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        showRow(tool, static_cast<std::size_t>(i));
  }
  ImGui::EndChild();
}

// --- Fields of the light that is picked ----------------------------------------------------------

void showName(const char* name) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(letters(kNameWidth));
  ImGui::SetNextItemWidth(-1);
}

struct FieldRange {
  double least;
  float perPixel;
  const char* format;
};

template <std::size_t kCount>
bool showNumbers(const char* name, std::array<double*, kCount> values, const FieldRange& range) {
  showName(name);
  std::array<double, kCount> shown;
  for (std::size_t i = 0; i < kCount; ++i) shown.at(i) = *values.at(i);
  ImGui::PushID(name);
  const bool isChanged = ImGui::DragScalarN("##field", ImGuiDataType_Double, shown.data(),
                                            static_cast<int>(kCount), range.perPixel, &range.least,
                                            &kLargest, range.format, ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopID();
  if (isChanged)
    for (std::size_t i = 0; i < kCount; ++i) *values.at(i) = shown.at(i);
  return isChanged;
}

bool showColor(LightSource& light) {
  showName("color");
  std::array<float, 3> shares{};
  for (int i = 0; i < 3; ++i)
    shares.at(static_cast<std::size_t>(i)) = static_cast<float>(light.share(i));
  if (!ImGui::ColorEdit3("##color", shares.data(),
                         ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueBar))
    return false;
  for (std::size_t i = 0; i < shares.size(); ++i)
    light.color[i] = static_cast<std::uint8_t>(std::lround(255 * shares.at(i)));
  return true;
}

bool showCurve(LightSource& light) {
  bool isChanged = false;
  for (std::size_t i = 0; i < light.curve.size(); ++i) {
    CurvePoint& point = light.curve[i];
    ImGui::PushID(static_cast<int>(i));
    showName(i == 0 ? "curve" : "");
    ImGui::SetNextItemWidth(-1);
    std::array<double, 2> shown{point.distance, point.level};
    if (ImGui::DragScalarN("##point", ImGuiDataType_Double, shown.data(), 2, kMetresPerPixel,
                           &kLeast, &kLargest, "%.2f", ImGuiSliderFlags_AlwaysClamp)) {
      point = {shown[0], shown[1]};
      isChanged = true;
    }
    ImGui::PopID();
  }
  return isChanged;
}

bool showStrength(LightSource& light) {
  if (!light.curve.empty()) return showCurve(light);
  const bool isBrighter = showNumbers<1>("intensity", {&light.intensity},
                                         {kLeast, kLevelsPerPixel, "%.1f levels of 255"});
  return showNumbers<1>("falloff", {&light.falloff}, {kLeast, kFalloffPerPixel, "%.3f per m"}) ||
         isBrighter;
}

/// The sector is of use only where sectors overlap.
bool showSector(LightDescription& light) {
  if (!light.sector) return false;
  showName("sector");
  showText(light.sector->name);
  ImGui::SameLine();
  if (!ImGui::Button("find by position")) return false;
  light.sector.reset();
  return true;
}

bool showFields(LightDescription& light) {
  LightSource& source = light.source;
  bool isChanged =
      showNumbers<3>("x, y, z", {&source.position.x, &source.position.y, &source.position.z},
                     {kNoLeast, kMetresPerPixel, kMetres});
  isChanged |= showSector(light);
  isChanged |= showNumbers<1>("radius", {&source.radius}, {kLeast, kMetresPerPixel, kMetres});
  isChanged |= showStrength(source);
  isChanged |= showColor(source);
  return isChanged;
}

/// As long as a field is held, what it changes is one step.
void editPicked(LightsEditor& editor) {
  LightDescription light = editor.pickedLight();
  if (showFields(light)) {
    if (!editor.isDragging() && ImGui::IsAnyItemActive()) editor.beginDrag();
    editor.set(light);
  }
  if (editor.isDragging() && !ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(0)) editor.endDrag();
}

void showNews(LightsEditor& editor) {
  if (!editor.message().empty()) showWrapped(editor.message());
  if (editor.hasConflict() && ImGui::Button("read the file, and drop what is edited here"))
    editor.openAgain();
}

}  // namespace

void showLights(LightsTool* tool, const Level& level, const Camera& camera) {
  const bool isPickedInPicture = tool && tool->takePick();
  if (isPickedInPicture) ImGui::SetNextItemOpen(true);
  if (!ImGui::CollapsingHeader("Lights", ImGuiTreeNodeFlags_DefaultOpen)) return;
  if (!tool)
    return showWrapped(
        "This walk is recorded or replayed, or takes its light from a file: lights "
        "cannot be edited.");
  LightsEditor& editor = tool->editor();
  if (!editor.isOpen()) return showNews(editor);
  showButtons(*tool, level, camera);
  showList(*tool, isPickedInPicture && editor.picked());
  if (editor.picked()) editPicked(editor);
  showNews(editor);
  showWrapped(
      "Drag a mark in the view: to the sides and up and down, with Shift only up and down. Drag it "
      "on the map (Tab) to move it over the plan. Ctrl+Z undoes, Ctrl+Y redoes, Ctrl+S saves.");
}

}  // namespace hearth
