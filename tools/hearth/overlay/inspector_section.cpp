#include "hearth/overlay/inspector_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hearth/inspect/places.h"
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

/// To three digits, but no finer than a hundredth.
std::string words(Vec3 levels) {
  const auto rounded = [](double level) { return std::round(100 * level) / 100; };
  return fmt::format("{:.3g} {:.3g} {:.3g}", rounded(levels.x), rounded(levels.y),
                     rounded(levels.z));
}

std::string words(Vec2 point) { return fmt::format("{:.3f},{:.3f}", point.x, point.y); }

std::string answer(const Inspection& found) {
  if (!found.lightmap) return "sky: always fully bright";
  const auto lit = std::ranges::count_if(
      found.lights, [](const LightFinding& light) { return light.reason == LightReason::Lights; });
  const std::size_t all = found.lights.size() + found.notFollowed;
  if (lit == 0) return fmt::format("dark: none of {} lights gives it a level", all);
  return fmt::format("{} of {} lights give it light", lit, all);
}

/// The section of one frame.
class Section {
 public:
  Section(const Inspection& found, const InspectedSurface& surface)
      : found_(found), place_(found.place), level_(surface.level), surface_(surface) {}

  InspectorRequest show(bool isPinned) {
    if (isPinned) {
      asked_.letsGo = ImGui::SmallButton("let go");
      ImGui::SameLine();
    }
    showText(answer(found_));
    ImGui::Separator();
    showLights();
    if (!found_.lights.empty()) ImGui::Separator();
    showPlace();
    if (found_.lightmap) showLightmap(*found_.lightmap);
    return asked_;
  }

 private:
  /// Lets the text before be clicked on, which copies another.
  void offer(const std::string& copied) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::SetTooltip("a click copies %s", copied.data());
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) asked_.copied = copied;
  }

  /// The same with a place in the level's files: `placeIn(source)` works it out.
  template <typename PlaceIn>
  void offerPlace(PlaceIn&& placeIn) {
    if (surface_.source && ImGui::IsItemHovered()) offer(placeIn(*surface_.source));
  }

  void showPlace() {
    showValue("surface", surfaceWords(level_, place_));
    offerPlace(
        [this](const LevelSource& source) { return placeOfSurface(source, level_, place_); });
    showValue("sector", level_[place_.sector].name);
    offerPlace([this](const LevelSource& source) { return placeOfSector(source, place_.sector); });
    if (place_.segment) showSegment(level_[*place_.segment]);
    showTexture();
    showValue("point", pointWords(place_.point));
    offer(pointWords(place_.point));
  }

  void showSegment(const Segment& segment) {
    showValue("segment", fmt::format("{} to {}, {:.3f} m", words(segment.p0), words(segment.p1),
                                     segment.length));
  }

  void showTexture() {
    showValue("texture", level_.textures[place_.texture->texture.index()]);
    offerPlace(
        [this](const LevelSource& source) { return placeOfTexture(source, level_, place_); });
    if (isSky(place_.kind)) return;  // which has directions alone
    const int width = surface_.texture.width();
    const int height = surface_.texture.height();
    const Vec2 pixel = texelOf(place_, width, height);
    showValue("uv", fmt::format("{} m, pixel {},{} of {} x {}", words(place_.imageMetres),
                                wrapped(pixel.x, width), wrapped(pixel.y, height), width, height));
  }

  void showLightmap(const LightmapFinding& map) {
    showValue("texel", fmt::format("{},{} of {} x {}, {:g} m wide", map.column, map.row,
                                   map.columns, map.rows, map.metres));
    showValue("lightmap",
              fmt::format("{}, mixed with its neighbours {}", words(map.texel), words(map.shown)));
    showValue("exactly", fmt::format("{} at this very point", words(found_.sum)));
    const double ambient = level_[place_.sector].light;
    if (ambient > 0)
      showValue("ambient",
                fmt::format("{:.0f} more: the sector's light {:g}", 255 * ambient, ambient));
  }

  void showLights() {
    const std::size_t listed = std::min(found_.lights.size(), kMostListedLights);
    for (std::size_t i = 0; i < listed; ++i) {
      ImGui::BeginGroup();
      showLight(found_.lights[i]);
      ImGui::EndGroup();
      if (ImGui::IsItemHovered()) asked_.light = i;
    }
    const std::size_t more = found_.lights.size() - listed + found_.notFollowed;
    if (more > 0) showText(fmt::format("and {} more", more));
  }

  void showLight(const LightFinding& finding) {
    showText(fmt::format("light {:<5}{:>8.2f} m   {}", finding.light, finding.distance,
                         finding.adds == Vec3{} ? "adds nothing" : "adds " + words(finding.adds)));
    offerPlace([&](const LevelSource& source) { return placeOfLight(source, finding.light); });
    const std::string reason = reasonWords(level_, finding);
    if (reason.empty()) return;
    ImGui::Indent(letters(kIndent));
    ImGui::PushStyleColor(ImGuiCol_Text, kReasonColor);
    showText(reason);
    ImGui::PopStyleColor();
    if (finding.blocker)
      offerPlace([&](const LevelSource& source) {
        return placeOfSurface(source, level_, *finding.blocker);
      });
    ImGui::Unindent(letters(kIndent));
  }

  const Inspection& found_;
  const TruthHit& place_;
  const Level& level_;
  const InspectedSurface& surface_;
  InspectorRequest asked_;
};

}  // namespace

InspectorRequest showInspection(const Inspection& found, const InspectedSurface& surface,
                                bool isPinned) {
  return Section(found, surface).show(isPinned);
}

}  // namespace hearth
