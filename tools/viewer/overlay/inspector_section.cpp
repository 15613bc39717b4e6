#include "viewer/overlay/inspector_section.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "math/wrapped.h"
#include "truth/truth_view.h"
#include "viewer/edit/lights_edit.h"
#include "viewer/inspect/places.h"
#include "viewer/inspect/words.h"
#include "viewer/overlay/imgui_values.h"
#include "viewer/overlay/light_rays.h"
#include "viewer/overlay/widgets.h"

namespace hearth {

namespace {

// In letters.
constexpr float kSurfaceNameWidth = 11;
constexpr float kIndent = 2;
constexpr int kDistanceWidth = 10;
constexpr int kLevelWidth = 8;

constexpr ImU32 kReasonColor = IM_COL32(255, 192, 96, 255);

void showValue(const char* name, const std::string& value) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(letters(kSurfaceNameWidth));
  showWrapped(value);
}

/// To three digits, but no finer than a hundredth.
std::string words(Vec3 levels) {
  const auto rounded = [](double level) { return std::round(100 * level) / 100; };
  return fmt::format("{:.3g} {:.3g} {:.3g}", rounded(levels.x), rounded(levels.y),
                     rounded(levels.z));
}

std::string words(Vec2 point) { return fmt::format("{:.3f}, {:.3f}", point.x, point.y); }

/// In the columns at the right of a list, which begin at `left`.
void showColumns(float left, const std::string& distance, const std::string& level) {
  ImGui::SameLine(left);
  ImGui::TextUnformatted(
      fmt::format("{:>{}}{:>{}}", distance, kDistanceWidth, level, kLevelWidth).data());
}

/// Lets the text before be clicked on, which copies another.
void offer(InspectorRequest& asked, const std::string& copied) {
  if (!ImGui::IsItemHovered()) return;
  showTip("A click copies " + copied);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) asked.copied = copied;
}

void showUnpin(InspectorRequest& asked) {
  asked.letsGo = ImGui::SmallButton("unpin");
  showTip("Then the pointer says again which place this is about. Esc does the same.");
}

/// The section of one frame.
class Section {
 public:
  Section(const Inspection& found, const InspectedSurface& surface)
      : found_(found), place_(found.place), level_(surface.level), surface_(surface) {}

  InspectorRequest show(bool isPinned) {
    showWrapped(brightnessWords(level_, found_));
    if (isPinned) showButtons();
    ImGui::Separator();
    showLights();
    if (!found_.lights.empty()) ImGui::Separator();
    showPlace();
    if (found_.lightmap) showLightmap(*found_.lightmap);
    return asked_;
  }

 private:
  void showButtons() {
    if (surface_.canAddLights && found_.lightmap) {
      asked_.addsLight = ImGui::SmallButton("add a light here");
      showTip("A metre before this surface, or half as far as there is room.");
      ImGui::SameLine();
      if (mayShine()) {
        asked_.letsShine = ImGui::SmallButton("let it shine");
        showTip("And all other surfaces that wear this texture. Lights has its fields.");
        ImGui::SameLine();
      }
    }
    showUnpin(asked_);
  }

  /// Whether its texture can be that of an emitter, and is of none.
  bool mayShine() const {
    const std::string& texture = level_.textures[place_.texture->texture.index()];
    return canShine(place_.kind) &&
           std::ranges::find(level_.lights, texture, &LightSource::texture) == level_.lights.end();
  }

  /// Lets the text before be clicked on, which copies a place in the level's files:
  /// `placeIn(source)` works it out.
  template <typename PlaceIn>
  void offerPlace(PlaceIn&& placeIn) {
    if (surface_.source && ImGui::IsItemHovered()) offer(asked_, placeIn(*surface_.source));
  }

  void showPlace() {
    showValue("surface", surfaceWords(level_, place_));
    offerPlace(
        [this](const LevelSource& source) { return placeOfSurface(source, level_, place_); });
    showValue("sector", level_[place_.sector].name);
    offerPlace([this](const LevelSource& source) { return placeOfSector(source, place_.sector); });
    if (place_.segment) showSegment(level_[*place_.segment]);
    showTexture();
    showValue("point", pointWords(place_.point, ", "));
    offer(asked_, pointWords(place_.point));
  }

  void showSegment(const Segment& segment) {
    showValue("from", words(segment.p0));
    showValue("to", fmt::format("{}; {:.3f} m long", words(segment.p1), segment.length));
  }

  void showTexture() {
    showValue("texture", level_.textures[place_.texture->texture.index()]);
    offerPlace(
        [this](const LevelSource& source) { return placeOfTexture(source, level_, place_); });
    if (isSky(place_.kind)) return;  // which has directions alone
    const int width = surface_.texture.width();
    const int height = surface_.texture.height();
    const Vec2 pixel = texelOf(place_, width, height);
    showValue("uv", fmt::format("{} m, pixel {}, {} of {} x {}", words(place_.imageMetres),
                                wrapped(pixel.x, width), wrapped(pixel.y, height), width, height));
  }

  void showLightmap(const LightmapFinding& map) {
    showValue("texel", fmt::format("{}, {} of {} x {}, {:g} m wide", map.column, map.row,
                                   map.columns, map.rows, map.metres));
    showValue("lightmap",
              fmt::format("{}; with its neighbours {}", words(map.texel), words(map.shown)));
    if (found_.bounced != Vec3{})
      showValue("bounced", fmt::format("{} {}", brightest(map.shown) < 255 ? "about" : "at least",
                                       words(found_.bounced)));
    showValue("exactly", fmt::format("{} of lights at this very point", words(found_.sum)));
  }

  void showLights() {
    const std::size_t listed = listedLights(found_);
    const float left = ImGui::GetContentRegionAvail().x - letters(kDistanceWidth + kLevelWidth);
    if (listed > 0) {
      ImGui::BeginDisabled();
      ImGui::BeginGroup();
      ImGui::TextUnformatted("lights, the strongest first");
      showColumns(left, "distance", "of 255");
      ImGui::EndGroup();
      ImGui::EndDisabled();
    }
    for (std::size_t i = 0; i < listed; ++i) {
      ImGui::BeginGroup();
      showLight(found_.lights[i], left);
      ImGui::EndGroup();
      if (ImGui::IsItemHovered()) asked_.light = i;
    }
    const auto near =
        static_cast<std::size_t>(std::ranges::count(found_.lights, true, &LightFinding::comesNear));
    showCount(near - listed, "weaker here");
    showCount(found_.lights.size() - near + found_.notFollowed,
              "too far away, too weak or behind walls");
  }

  /// Of lights that are not listed.
  static void showCount(std::size_t count, const char* what) {
    if (count == 0) return;
    ImGui::BeginDisabled();
    showWrapped(fmt::format("{} more {}: {}", count, count == 1 ? "light" : "lights", what));
    ImGui::EndDisabled();
  }

  /// `left`: where the columns begin.
  void showLight(const LightFinding& finding, float left) {
    showHead(finding, left);
    const std::string reason = reasonWords(level_, place_, finding);
    if (reason.empty()) return;
    ImGui::Indent(letters(kIndent));
    ImGui::PushStyleColor(ImGuiCol_Text, kReasonColor);
    showWrapped(reason);
    ImGui::PopStyleColor();
    if (finding.blocker)
      offerPlace([&](const LevelSource& source) {
        return placeOfSurface(source, level_, *finding.blocker);
      });
    ImGui::Unindent(letters(kIndent));
  }

  /// Its color, its name and its figures, which can be clicked on.
  void showHead(const LightFinding& finding, float left) {
    const float line = ImGui::GetTextLineHeight();
    const std::string name =
        brokenAtBlanks(surface_.nameOf(finding.light), left - letters(kIndent));
    ImGui::PushID(static_cast<int>(finding.light));
    if (ImGui::Selectable("##light", surface_.picked == finding.light,
                          ImGuiSelectableFlags_AllowItemOverlap,
                          {0, ImGui::CalcTextSize(name.data()).y}))
      asked_.picked = finding.light;
    ImGui::PopID();
    if (ImGui::IsItemHovered()) offerLight(finding.light);
    ImGui::SameLine(letters(kIndent));
    const ImVec2 corner = ImGui::GetItemRectMin();
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x + line / 4, corner.y + line / 4},
                                              {corner.x + line, corner.y + line},
                                              imColor(colorOf(level_.lights[finding.light])));
    ImGui::TextUnformatted(name.data());
    const LightSource& light = level_.lights[finding.light];
    const std::string away = light.isEmitter() ? "surfaces"
                             : light.isSky     ? "sky"
                             : light.sun       ? "sun"
                                               : fmt::format("{:.2f} m", finding.distance);
    showColumns(left, away, levelWords(brightest(finding.adds)));
  }

  void offerLight(std::size_t light) {
    std::string tip = surface_.canAddLights ? "A click picks it in Lights." : "";
    if (surface_.source) {
      const std::string place = placeOfLight(*surface_.source, light);
      if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) asked_.copied = place;
      tip += fmt::format("{}A right click copies {}", tip.empty() ? "" : "\n", place);
    }
    if (!tip.empty()) showTip(tip);
  }

  const Inspection& found_;
  const TruthHit& place_;
  const Level& level_;
  const InspectedSurface& surface_;
  InspectorRequest asked_;
};

}  // namespace

std::string InspectedSurface::nameOf(std::size_t light) const {
  const LightSource& of = level.lights[light];
  if (!source) return lightName(light, of, "");
  const Place place = source->lights.at(light).place;
  return lightName(light, of, commentAt(source->documents[place.document].text, place.offset));
}

std::size_t listedLights(const Inspection& found) {
  const auto end = std::ranges::find(found.lights, false, &LightFinding::comesNear);
  return std::min(kMaxListedLights, static_cast<std::size_t>(end - found.lights.begin()));
}

InspectorRequest showSprite(const Level& level, const SpriteHit& found, const BakedLight& light,
                            const LevelSource* source, bool isPinned) {
  const Sprite& sprite = level.sprites[found.sprite];
  InspectorRequest asked;
  showWrapped(spriteBrightnessWords(level, found.sprite, light));
  if (isPinned) showUnpin(asked);
  ImGui::Separator();
  showValue("sprite", spriteWords(level, found.sprite));
  if (source) offer(asked, placeOfSprite(*source, found.sprite));
  showValue("sector", level[sprite.sector].name);
  if (source) offer(asked, placeOfSector(*source, sprite.sector));
  showValue("image", level.textures[found.image.index()]);
  if (source) offer(asked, placeOfSpriteImage(*source, found.sprite));
  showValue("position", pointWords(sprite.position, ", "));
  offer(asked, pointWords(sprite.position));
  if (sprite.body)
    showValue("body",
              fmt::format("radius {:g} m, {:g} m high", sprite.body->radius, sprite.body->height));
  return asked;
}

InspectorRequest showMesh(const Level& level, const MeshHit& found, const BakedLight& light,
                          const LevelSource* source, bool isPinned) {
  const Mesh& mesh = level.meshes[found.mesh];
  InspectorRequest asked;
  showWrapped(meshBrightnessWords(level, found, light));
  if (isPinned) showUnpin(asked);
  ImGui::Separator();
  showValue("mesh", meshWords(level, found.mesh));
  if (source) offer(asked, placeOfMesh(*source, found.mesh));
  if (source) showValue("model", source->level.meshes[found.mesh].file.name);
  if (source) offer(asked, placeOfModel(*source, found.mesh));
  showValue("face", fmt::format("{} of {}", found.face - mesh.firstFace, mesh.faceCount));
  showValue("sector", level[mesh.sector].name);
  if (source) offer(asked, placeOfSector(*source, mesh.sector));
  showValue("image", level.textures[level.meshFaces[found.face].texture.index()]);
  showValue("position", pointWords(mesh.position, ", "));
  offer(asked, pointWords(mesh.position));
  return asked;
}

InspectorRequest showInspection(const Inspection& found, const InspectedSurface& surface,
                                bool isPinned) {
  return Section(found, surface).show(isPinned);
}

}  // namespace hearth
