#include "hearth/overlay/inspector_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hearth/inspect/words.h"
#include "math/wrapped.h"
#include "truth/truth_view.h"

namespace hearth {

namespace {

// In letters.
constexpr float kNameWidth = 11;
constexpr float kIndent = 2;

constexpr ImU32 kReasonColor = IM_COL32(255, 192, 96, 255);

float letters(float count) { return count * ImGui::CalcTextSize("M").x; }

/// Broken at the panel's edge.
void showText(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.data());
  ImGui::PopTextWrapPos();
}

void showValue(const char* name, const std::string& value) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(letters(kNameWidth));
  showText(value);
}

std::string words(Vec3 levels) {
  return fmt::format("{:.0f} {:.0f} {:.0f}", levels.x, levels.y, levels.z);
}

std::string words(Vec2 point) { return fmt::format("{:.3f},{:.3f}", point.x, point.y); }

// --- The place -----------------------------------------------------------------------------------

void showSegment(const Level& level, SegmentId id) {
  const Segment& segment = level[id];
  showValue("segment", fmt::format("{} to {}, {:.3f} m", words(segment.p0), words(segment.p1),
                                   segment.length));
}

void showTexture(const Level& level, const TruthHit& place, const Texture& texture) {
  showValue("texture", level.textures[place.texture->texture.index()]);
  if (isSky(place.kind)) return;  // which has directions alone
  const Vec2 pixel = texelOf(place, texture.width(), texture.height());
  showValue("uv", fmt::format("{} m, pixel {},{} of {} x {}", words(place.imageMetres),
                              wrapped(pixel.x, texture.width()), wrapped(pixel.y, texture.height()),
                              texture.width(), texture.height()));
}

void showPlace(const Level& level, const TruthHit& place, const Texture& texture) {
  showValue("surface", surfaceWords(level, place));
  showValue("sector", level[place.sector].name);
  if (place.segment) showSegment(level, *place.segment);
  showTexture(level, place, texture);
  showValue("point", pointWords(place.point));
}

// --- Its light -----------------------------------------------------------------------------------

std::string answer(const Inspection& found) {
  if (!found.lightmap) return "sky: always fully bright";
  const auto lit = std::ranges::count_if(
      found.lights, [](const LightFinding& light) { return light.reason == LightReason::Lights; });
  const std::size_t all = found.lights.size() + found.notFollowed;
  if (lit == 0) return fmt::format("dark: none of {} lights gives it a level", all);
  return fmt::format("{} of {} lights give it light", lit, all);
}

void showLightmap(const LightmapFinding& map, const Inspection& found, double sectorLight) {
  showValue("texel", fmt::format("{},{} of {} x {}, {:g} m wide", map.column, map.row, map.columns,
                                 map.rows, map.metres));
  showValue("lightmap",
            fmt::format("{}, mixed with its neighbours {}", words(map.texel), words(map.shown)));
  showValue("exactly", fmt::format("{} at this very point", words(found.sum)));
  if (sectorLight > 0)
    showValue("ambient",
              fmt::format("{:.0f} more: the sector's light {:g}", 255 * sectorLight, sectorLight));
}

/// Returns whether the pointer is on it.
bool showLight(const Level& level, const LightFinding& finding) {
  ImGui::BeginGroup();
  showText(fmt::format("light {:<5}{:>8.2f} m   {}", finding.light, finding.distance,
                       finding.adds == Vec3{} ? "adds nothing" : "adds " + words(finding.adds)));
  if (const std::string reason = reasonWords(level, finding); !reason.empty()) {
    ImGui::Indent(letters(kIndent));
    ImGui::PushStyleColor(ImGuiCol_Text, kReasonColor);
    showText(reason);
    ImGui::PopStyleColor();
    ImGui::Unindent(letters(kIndent));
  }
  ImGui::EndGroup();
  return ImGui::IsItemHovered();
}

std::optional<std::size_t> showLights(const Level& level, const Inspection& found) {
  std::optional<std::size_t> pointed;
  const std::size_t listed = std::min(found.lights.size(), kMostListedLights);
  for (std::size_t i = 0; i < listed; ++i)
    if (showLight(level, found.lights[i])) pointed = i;
  const std::size_t more = found.lights.size() - listed + found.notFollowed;
  if (more > 0) showText(fmt::format("and {} more", more));
  return pointed;
}

}  // namespace

InspectorRequest showInspection(const Inspection& found, const Level& level, const Texture& texture,
                                bool isPinned) {
  InspectorRequest asked;
  if (isPinned) {
    asked.letsGo = ImGui::SmallButton("let go");
    ImGui::SameLine();
  }
  showText(answer(found));
  ImGui::Separator();
  asked.light = showLights(level, found);
  if (!found.lights.empty()) ImGui::Separator();
  showPlace(level, found.place, texture);
  if (found.lightmap) showLightmap(*found.lightmap, found, level[found.place.sector].light);
  return asked;
}

}  // namespace hearth
