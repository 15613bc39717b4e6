#include "viewer/overlay/drag_axes.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "viewer/overlay/imgui_values.h"
#include "viewer/overlay/overlay.h"

namespace hearth {

namespace {

struct AxisLook {
  Axis axis;
  Vec3 direction;
  const char* name;
  ImU32 color;
};
constexpr std::array kAxes = {
    AxisLook{Axis::X, {1, 0, 0}, "x", IM_COL32(255, 96, 80, 255)},
    AxisLook{Axis::Y, {0, 1, 0}, "y", IM_COL32(112, 224, 96, 255)},
    AxisLook{Axis::Z, {0, 0, 1}, "z up", IM_COL32(112, 160, 255, 255)},
};

/// An axis is drawn so long, but in pixels of the smallest letters within these bounds.
constexpr double kMetres = 0.5;
constexpr double kShortest = 14;
constexpr double kLongest = 60;
/// Of its projection: less is none. The map has no heights.
constexpr double kNone = 1e-6;

// In pixels of the smallest letters.
constexpr Vec2 kToName{4, -7};  // from the tip of an axis
constexpr float kThickness = 2;
constexpr float kBelowMark = 20;
constexpr float kPadding = 3;
constexpr ImU32 kGround = IM_COL32(0, 0, 0, 176);
constexpr ImU32 kText = IM_COL32(255, 255, 255, 255);

void drawAxis(const AxisLook& axis, Vec3 position, Vec2 mark, const MarkerSpace& space,
              double scale) {
  const auto end = space.pixelOf(position + kMetres * axis.direction);
  if (!end || length(*end - mark) < kNone) return;
  const double pixels = length(*end - mark);
  const double shown = std::clamp(pixels, kShortest * scale, kLongest * scale);
  const Vec2 tip = mark + shown / pixels * (*end - mark);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddLine(imVec(mark), imVec(tip), axis.color, kThickness * static_cast<float>(scale));
  list.AddText(imVec(tip + scale * kToName), axis.color, axis.name);
}

void drawPosition(Vec3 position, Vec2 mark, float scale) {
  const std::string text = fmt::format("x {}  y {}  z {}", position.x, position.y, position.z);
  const ImVec2 size = ImGui::CalcTextSize(text.data());
  const ImVec2 corner{static_cast<float>(mark.x) - size.x / 2,
                      static_cast<float>(mark.y) + kBelowMark * scale};
  const float padding = kPadding * scale;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled({corner.x - padding, corner.y - padding},
                     {corner.x + size.x + padding, corner.y + size.y + padding}, kGround);
  list.AddText(corner, kText, text.data());
}

}  // namespace

void drawDragAxes(const LightsTool& tool, const MarkerSpace& space, int pictureHeight) {
  const auto drag = tool.drag();
  if (!drag) return;
  const auto mark = space.pixelOf(drag->position);
  if (!mark) return;
  const int scale = letterScale(pictureHeight);
  for (const AxisLook& axis : kAxes)
    if (!drag->axis || drag->axis == axis.axis) drawAxis(axis, drag->position, *mark, space, scale);
  drawPosition(drag->position, *mark, static_cast<float>(scale));
}

}  // namespace hearth
