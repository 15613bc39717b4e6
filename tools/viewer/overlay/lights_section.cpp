#include "viewer/overlay/lights_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "viewer/edit/curve_edit.h"
#include "viewer/edit/lights_edit.h"
#include "viewer/overlay/widgets.h"

namespace hearth {

namespace {

constexpr int kRows = 6;                         // of the list that show at once
constexpr float kLightNameWidth = 11;            // of a field, in letters
constexpr double kLargest = 1e9;                 // of all fields; the loader takes no more
constexpr std::size_t kLongestLightName = 1000;  // bytes

bool showButton(const char* name, bool isEnabled) {
  ImGui::BeginDisabled(!isEnabled);
  const bool isPressed = ImGui::Button(name);
  ImGui::EndDisabled();
  return isPressed;
}

void showButtons(LightsTool& tool, const Scene& scene, const Camera& camera) {
  LightsEditor& editor = tool.editor();
  if (showButton("add", true)) tool.addBefore(scene, camera);
  showTip("Before the eye. Inspector adds one before a surface that is clicked on.");
  ImGui::SameLine();
  if (showButton("delete", editor.picked().has_value())) {
    tool.release();
    editor.removePicked();
  }
  ImGui::SameLine();
  if (showButton("undo", editor.canUndo())) editor.undo();
  showTip("Ctrl+Z");
  ImGui::SameLine();
  if (showButton("redo", editor.canRedo())) editor.redo();
  showTip("Ctrl+Y, or Ctrl+Shift+Z");
  ImGui::SameLine();
  if (showButton("save", editor.isUnsaved())) tool.save(scene);
  showTip("Ctrl+S. It is grey while all is saved.");
  ImGui::SameLine();
  bool areShown = tool.areMarksShown();
  if (ImGui::Checkbox("marks", &areShown)) tool.showMarks(areShown);
  showTip("Of lights, in the picture. Behind walls they are hollow.");
  ImGui::SameLine();
  if (showButton("add sun", true)) tool.addSun(camera);
  showTip("Where the camera looks. Its light comes in wherever the sky is seen.");
  ImGui::SameLine();
  if (showButton("add sky", !editor.lights().sky)) tool.addSky();
  showTip("Light from all of the sky, wherever it is seen.");
}

// --- The list ------------------------------------------------------------------------------------

ImVec4 swatchOf(const LightSource& light) {
  return {static_cast<float>(light.colorFactor(0)), static_cast<float>(light.colorFactor(1)),
          static_cast<float>(light.colorFactor(2)), 1};
}

void showRow(LightsTool& tool, std::size_t i) {
  LightsEditor& editor = tool.editor();
  const float height = ImGui::GetTextLineHeight();
  ImGui::PushID(static_cast<int>(i));
  ImGui::ColorButton("##color", swatchOf(editor.lights().at(i).source),
                     ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                     {height, height});
  ImGui::SameLine();
  const ImVec2 begin = ImGui::GetCursorPos();
  if (ImGui::Selectable("##light", editor.picked() == i)) {
    tool.release();
    editor.pick(i);
  }
  ImGui::SetCursorPos(begin);
  showText(lightName(i, editor.lights().at(i).source, editor.commentOf(i)));
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
    clipper.Begin(static_cast<int>(editor.lights().count()));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        showRow(tool, static_cast<std::size_t>(i));
  }
  ImGui::EndChild();
}

// --- Fields of the light that is picked ----------------------------------------------------------

void showLabel(const char* name) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(letters(kLightNameWidth));
  ImGui::SetNextItemWidth(-1);
}

/// Of a field. It is dragged so far for each pixel of the mouse; farther where its number is large,
/// by a fraction of it.
struct FieldRange {
  double least;
  double most;
  double perPixel;
  double fractionPerPixel;
  const char* format;
  const char* tip;
};
constexpr FieldRange kPosition{
    -kLargest, kLargest, 0.02, 0, "%.3f m", "x to the right on the map, y down on it, z up."};
constexpr FieldRange kRadius{
    0, kLargest, 0.005, 0.01, "%.3f m", "Of a ball of light, which has soft shadows. 0: a point."};
constexpr FieldRange kIntensity{0, kLargest, 1, 0.01, "%.1f of 255", "Levels of light at 0 m."};
constexpr FieldRange kFalloff{0,
                              kLargest,
                              0.004,
                              0.02,
                              "%.3f per m",
                              "At d metres there is intensity / (d x falloff + 1): 0.3 for a lamp "
                              "that fills a hall, 0.8 for a pool of light."};

constexpr FieldRange kAngle{-1e6, 1e6, 0.5, 0, "%.1f deg", "On the map: 0 along x, 90 along y."};
constexpr FieldRange kPitch{-90, 90, 0.5, 0, "%.1f deg", "Upwards; below 0 downwards."};

constexpr FieldRange kHeight{1, 90, 0.25, 0, "%.1f deg", "Over the horizon; 90 is overhead."};
constexpr FieldRange kSunSize{
    0, 20, 0.05, 0, "%.2f deg", "Across its disc, which makes soft shadows. 0: a point."};
constexpr FieldRange kSunIntensity{0,    kLargest,      1,
                                   0.01, "%.1f of 255", "Levels of light where all of it is seen."};
constexpr FieldRange kSkyIntensity{
    0, kLargest, 1, 0.01, "%.1f of 255", "Levels of light on level ground in the open."};
constexpr FieldRange kEmitted{0,
                              kLargest,
                              1,
                              0.01,
                              "%.1f of 255",
                              "Levels of light on what sees nothing else. The "
                              "surface itself is drawn that bright."};

/// Of a light that becomes a spot: straight down.
const Spot kFirstSpot(0, -90, 20, 40);

/// As wide as was asked for.
bool showNumber(const char* id, double& value, const FieldRange& range) {
  const double speed = std::max(range.perPixel, range.fractionPerPixel * std::abs(value));
  const bool isChanged =
      ImGui::DragScalar(id, ImGuiDataType_Double, &value, static_cast<float>(speed), &range.least,
                        &range.most, range.format, ImGuiSliderFlags_AlwaysClamp);
  if (!ImGui::IsItemActive())
    showTip(fmt::format("{}\nDrag it, or click to type a number.", range.tip));
  return isChanged;
}

bool showField(const char* name, double& value, const FieldRange& range) {
  showLabel(name);
  ImGui::PushID(name);
  const bool isChanged = showNumber("##field", value, range);
  ImGui::PopID();
  return isChanged;
}

/// `count` fields side by side, with room for `right` pixels behind them.
float widthOfEach(int count, float right = 0) {
  const float gaps = static_cast<float>(count - 1) * ImGui::GetStyle().ItemInnerSpacing.x;
  return (ImGui::GetContentRegionAvail().x - gaps - right) / static_cast<float>(count);
}

bool showPosition(Vec3& position) {
  showLabel("x, y, z");
  const float width = widthOfEach(3);
  bool isChanged = false;
  const auto show = [&](const char* id, double& value) {
    ImGui::SetNextItemWidth(width);
    isChanged |= showNumber(id, value, kPosition);
  };
  show("##x", position.x);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  show("##y", position.y);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  show("##z", position.z);
  return isChanged;
}

/// Two fields side by side.
bool showPair(const char* name, double& first, const FieldRange& ofFirst, double& second,
              const FieldRange& ofSecond) {
  showLabel(name);
  ImGui::PushID(name);
  const float width = widthOfEach(2);
  ImGui::SetNextItemWidth(width);
  bool isChanged = showNumber("##first", first, ofFirst);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::SetNextItemWidth(width);
  isChanged |= showNumber("##second", second, ofSecond);
  ImGui::PopID();
  return isChanged;
}

bool showSpot(std::optional<Spot>& spot) {
  showLabel("spot");
  bool isOn = spot.has_value();
  bool isChanged = ImGui::Checkbox("##spot", &isOn);
  showTip("Light goes out around one direction only.");
  if (isChanged) spot = isOn ? std::optional(kFirstSpot) : std::nullopt;
  if (!spot) return isChanged;
  double angle = spot->angle();
  double pitch = spot->pitch();
  double inner = spot->inner();
  double outer = spot->outer();
  const FieldRange toInner{0, outer,      0.25,
                           0, "%.1f deg", "From the direction, up to which light is full."};
  const FieldRange toOuter{inner, 180,        0.25,
                           0,     "%.1f deg", "From the direction, where light ends."};
  isChanged |= showPair("direction", angle, kAngle, pitch, kPitch);
  isChanged |= showPair("cone", inner, toInner, outer, toOuter);
  if (isChanged) spot = Spot(angle, pitch, inner, outer);
  return isChanged;
}

bool showColor(LightSource& light) {
  showLabel("color");
  std::array<float, 3> fractions{};
  for (int i = 0; i < 3; ++i)
    fractions.at(static_cast<std::size_t>(i)) = static_cast<float>(light.colorFactor(i));
  if (!ImGui::ColorEdit3("##color", fractions.data(),
                         ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueBar))
    return false;
  for (std::size_t i = 0; i < fractions.size(); ++i)
    light.color[i] = static_cast<std::uint8_t>(std::lround(255 * fractions.at(i)));
  return true;
}

// --- A curve -------------------------------------------------------------------------------------

/// Its distance stays between those of its neighbours.
bool showPoint(std::vector<CurvePoint>& curve, std::size_t i, float width) {
  const FieldRange distance{i > 0 ? curve[i - 1].distance : 0,
                            i + 1 < curve.size() ? curve[i + 1].distance : kLargest,
                            0.02,
                            0,
                            "at %.2f m",
                            "Of this point of the curve, between those beside it."};
  const FieldRange level{
      0, kLargest,      1,
      0, "%.1f of 255", "Levels of light there. Between two points they change evenly."};
  ImGui::SetNextItemWidth(width);
  const bool isMoved = showNumber("##distance", curve[i].distance, distance);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::SetNextItemWidth(width);
  return showNumber("##level", curve[i].level, level) || isMoved;
}

/// Two buttons behind a point, square ones, add another and take it out.
bool showPointButtons(std::vector<CurvePoint>& curve, std::size_t i) {
  const ImVec2 square{ImGui::GetFrameHeight(), ImGui::GetFrameHeight()};
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  const bool isAdded = ImGui::Button("+", square);
  showTip("Adds a point behind this one, which changes nothing yet.");
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::BeginDisabled(curve.size() == 1);
  const bool isTakenOut = ImGui::Button("-", square);
  ImGui::EndDisabled();
  showTip("Takes this point out.");
  if (isAdded) curve = withPointBehind(curve, i);
  if (isTakenOut) curve = withoutPoint(curve, i);
  return isAdded || isTakenOut;
}

bool showCurve(std::vector<CurvePoint>& curve) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    showLabel(i == 0 ? "curve" : "");
    const float buttons = 2 * (ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::PushID(static_cast<int>(i));
    bool isChanged = showPoint(curve, i, widthOfEach(2, buttons));
    isChanged |= showPointButtons(curve, i);
    ImGui::PopID();
    if (isChanged) return true;  // the rest in the next frame
  }
  return false;
}

bool showStrength(LightSource& light) {
  if (!light.curve.empty()) return showCurve(light.curve);
  const bool isBrighter = showField("intensity", light.intensity, kIntensity);
  return showField("falloff", light.falloff, kFalloff) || isBrighter;
}

/// The sector is of use only where sectors overlap.
bool showSector(LightDescription& light) {
  if (!light.sector) return false;
  showLabel("sector");
  showText(light.sector->name);
  ImGui::SameLine();
  if (!ImGui::Button("find by position")) return false;
  light.sector.reset();
  return true;
}

bool showFieldsOfSun(LightSource& source) {
  double angle = source.sun->angle();
  double pitch = source.sun->pitch();
  double size = source.sun->size();
  bool isChanged = showPair("direction", angle, kAngle, pitch, kHeight);
  isChanged |= showField("size", size, kSunSize);
  if (isChanged) source.sun.emplace(angle, pitch, size);
  isChanged |= showField("intensity", source.intensity, kSunIntensity);
  return showColor(source) || isChanged;
}

bool showFieldsOfArea(LightSource& source) {
  const bool isChanged =
      showField("intensity", source.intensity, source.isSky ? kSkyIntensity : kEmitted);
  return showColor(source) || isChanged;
}

bool showFields(LightDescription& light) {
  LightSource& source = light.source;
  if (source.isArea()) return showFieldsOfArea(source);
  if (source.sun) return showFieldsOfSun(source);
  bool isChanged = showPosition(source.position);
  isChanged |= showSector(light);
  isChanged |= showField("radius", source.radius, kRadius);
  isChanged |= showStrength(source);
  isChanged |= showColor(source);
  isChanged |= showSpot(source.spot);
  return isChanged;
}

/// The comment of a light. Returns whether it has been changed.
bool showName(std::string& comment) {
  showLabel("name");
  std::array<char, kLongestLightName + 1> typed{};
  comment.copy(typed.data(), kLongestLightName);
  const bool isChanged = ImGui::InputTextWithHint("##name", "none", typed.data(), typed.size());
  showTip("Its comment in the file.");
  if (isChanged) comment = typed.data();
  return isChanged;
}

/// As long as a field is held, what it changes is one step.
void editPicked(LightsEditor& editor) {
  LightDescription light = editor.pickedLight();
  std::string comment = editor.commentOf(*editor.picked());
  const bool isRenamed = showName(comment);
  const bool isChanged = showFields(light);
  if ((isRenamed || isChanged) && !editor.isDragging() && ImGui::IsAnyItemActive())
    editor.beginDrag();
  if (isRenamed) editor.setComment(comment);
  if (isChanged) editor.set(light);
  if (editor.isDragging() && !ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(0)) editor.endDrag();
}

void showNews(LightsEditor& editor) {
  if (!editor.message().empty()) showWrapped(editor.message());
  if (editor.hasConflict() && ImGui::Button("read the file, and drop what is edited here"))
    editor.openAgain();
}

}  // namespace

void showLights(LightsTool* tool, const Scene& scene, const Camera& camera) {
  CollapsibleSection none;
  CollapsibleSection& section = tool ? tool->section() : none;
  const bool isRevealed = section.isRevealed();
  if (!section.show("Lights")) return;
  if (!tool)
    return showWrapped(
        "This walk is recorded or replayed, or takes its light from a file: lights "
        "cannot be edited.");
  LightsEditor& editor = tool->editor();
  if (!editor.isOpen()) return showNews(editor);
  showButtons(*tool, scene, camera);
  showList(*tool, isRevealed && editor.picked());
  if (editor.picked()) editPicked(editor);
  showNews(editor);
  showWrapped(
      "Drag a mark in the picture, or on the map (Tab); with x, y or z held it moves along that "
      "axis alone. Drag a number, or click to type one.");
}

}  // namespace hearth
