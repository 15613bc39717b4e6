#include "viewer/walk/walk_panel.h"

#include <array>
#include <cstddef>

#include "settings/settings.h"
#include "viewer/overlay/drag_axes.h"
#include "viewer/overlay/lights_section.h"
#include "viewer/overlay/quality_section.h"
#include "viewer/overlay/view_section.h"

namespace hearth {

namespace {

constexpr std::size_t kLightPage = 0;

}  // namespace

void WalkPanel::toggle() {
  overlay_.toggle();
  releasePointer();
  if (lights_ && isOpen()) lights()->open();
  preferencesSection_.giveUp();
}

void WalkPanel::releasePointer() {
  pointer_.release();
  if (lights_) lights_->release();
}

void WalkPanel::editLights(Storage& storage, const std::filesystem::path& file,
                           const LoadLimits& limits) {
  if (lights_ && (lights()->file() == file || lights()->isUnsaved())) return;
  lights_.emplace(storage, file, limits);
}

bool WalkPanel::take(const Event& event, const PanelScene& scene, Preferences& preferences) {
  if (!isOpen()) return false;
  if (preferencesSection_.take(event, preferences)) {
    overlay_.refresh();
    return true;
  }
  point(event, scene);
  const auto* key = std::get_if<KeyEvent>(&event);
  const bool isKeyOfLights = lights_ && key && key->isDown;
  if (isKeyOfLights && LightsTool::isSave(*key)) {
    overlay_.refresh();
    return lights_->take(*key, scene.level);
  }
  if (overlay_.take(event)) return true;
  return isKeyOfLights && lights_->take(*key, scene.level);
}

/// What the mouse does in the picture beside the panel is about a light, if it is at one, and else
/// about what shows there.
void WalkPanel::point(const Event& event, const PanelScene& scene) {
  const int panelLeft = overlay_.hasPopup() ? 0 : overlay_.leaves(scene.size.width);
  const std::optional<PointerEvent> pointed = pointer_.take(event, panelLeft);
  if (pointed && pointed->kind == PointerEvent::Kind::Press) pages_.turnTo(kLightPage);
  const bool isOfLight = pointed && scene.space && lights_ &&
                         lights_->take(*pointed, *scene.space, scene.camera.height);
  inspector_.take(event, scene.isLevelShown && !isOfLight ? panelLeft : 0);
}

void WalkPanel::drawMarks(const PanelScene& scene, Image& picture) const {
  if (isOpen() && lights_ && scene.space)
    lights_->draw(scene.level, scene.camera, *scene.space, picture);
}

PanelWishes WalkPanel::draw(double now, const PanelScene& scene, const Figures& figures,
                            WalkSettings& settings, WalkView& view, Image& picture) {
  PanelWishes wishes;
  if (!isOpen()) return wishes;
  if (settings.canBake) bake_ = bakeSettingsFrom(scene.level, settings.options);
  const std::array<Page, 6> pages = {{
      {"Light", [&] { wishes.copied = showLightPage(scene); }},
      {"View", [&] { showView(view.mode, view.channel); }},
      {"Quality", [&] { wishes.areOptionsNew = showQualityOf(scene, settings); }},
      {"Figures", [&] { showFigures(figures); }},
      {"Comfort",
       [&] { wishes.arePreferencesNew = preferencesSection_.show(settings.preferences); }},
      {"Bookmarks",
       [&] { wishes.bookmark = bookmarksSection_.show(settings.bookmarks, scene.bookmarks); }},
  }};
  overlay_.draw(
      now, [&] { pages_.show(pages); }, picture);
  return wishes;
}

/// Returns what is to be copied.
std::optional<std::string> WalkPanel::showLightPage(const PanelScene& scene) {
  LightsTool* const lights = lights_ ? &*lights_ : nullptr;
  auto copied = inspector_.show(
      {scene.level, scene.renderer, bake_, scene.source, lights, scene.isLevelShown}, scene.camera);
  showLights(lights, scene.level, scene.camera);
  if (lights && scene.space) drawDragAxes(*lights, *scene.space, scene.size.height);
  return copied;
}

bool WalkPanel::showQualityOf(const PanelScene& scene, WalkSettings& settings) {
  QualityChoice choice{settings.options, settings.fov, settings.frameCap};
  const bool isNew =
      showQuality({scene.level.bake, bake_, scene.renderer.settings(), settings.canBake}, choice);
  settings.options = choice.options;
  settings.fov = choice.fov;
  settings.frameCap = choice.frameCap;
  return isNew;
}

}  // namespace hearth
