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

bool WalkPanel::take(const Event& event, const PanelSubject& subject, Preferences& preferences) {
  if (!isOpen()) return false;
  if (preferencesSection_.take(event, preferences)) {
    overlay_.refresh();
    return true;
  }
  point(event, subject);
  const auto* key = std::get_if<KeyEvent>(&event);
  const bool isKeyOfLights = lights_ && key && key->isDown;
  if (isKeyOfLights && LightsTool::isSave(*key)) {
    overlay_.refresh();
    return lights_->take(*key, subject.scene);
  }
  if (overlay_.take(event)) return true;
  return isKeyOfLights && lights_->take(*key, subject.scene);
}

/// Handles what the mouse does in the picture beside the panel. It is about a light if the mouse is
/// at one. Otherwise it is about what shows there.
void WalkPanel::point(const Event& event, const PanelSubject& subject) {
  const int panelLeft = overlay_.hasPopup() ? 0 : overlay_.leaves(subject.size.width);
  const std::optional<PointerEvent> pointed = pointer_.take(event, panelLeft);
  if (pointed && pointed->kind == PointerEvent::Kind::Press) pages_.turnTo(kLightPage);
  const bool isOfLight = pointed && subject.space && lights_ &&
                         lights_->take(*pointed, *subject.space, subject.camera.height);
  inspector_.take(event, subject.isLevelShown && !isOfLight ? panelLeft : 0);
}

void WalkPanel::drawMarks(const PanelSubject& subject, const PixelRows& picture) const {
  if (isOpen() && lights_ && subject.space)
    lights_->draw(subject.scene, subject.camera, *subject.space, picture);
}

PanelWishes WalkPanel::draw(double now, const PanelSubject& subject, const Figures& figures,
                            WalkSettings& settings, WalkView& view, const PixelRows& picture) {
  PanelWishes wishes;
  if (!isOpen()) return wishes;
  if (settings.canBake) bake_ = bakeSettingsFrom(subject.scene, settings.options);
  const std::array<Page, 6> pages = {{
      {"Light", [&] { wishes.copied = showLightPage(subject); }},
      {"View", [&] { showView(view.mode, view.channel); }},
      {"Quality", [&] { wishes.areOptionsNew = showQualityOf(subject, settings); }},
      {"Figures", [&] { showFigures(figures); }},
      {"Preferences",
       [&] { wishes.arePreferencesNew = preferencesSection_.show(settings.preferences); }},
      {"Bookmarks",
       [&] { wishes.bookmark = bookmarksSection_.show(settings.bookmarks, subject.bookmarks); }},
  }};
  overlay_.draw(
      now, [&] { pages_.show(pages); }, picture);
  return wishes;
}

/// Returns the text to copy to the clipboard, if any.
std::optional<std::string> WalkPanel::showLightPage(const PanelSubject& subject) {
  LightsTool* const lights = lights_ ? &*lights_ : nullptr;
  auto copied = inspector_.show(
      {subject.scene, subject.renderer, bake_, subject.source, lights, subject.isLevelShown},
      subject.camera);
  showLights(lights, subject.scene, subject.camera);
  if (lights && subject.space) drawDragAxes(*lights, *subject.space, subject.size.height);
  return copied;
}

bool WalkPanel::showQualityOf(const PanelSubject& subject, WalkSettings& settings) {
  QualityChoice choice{settings.options, settings.fov, settings.frameCap};
  const bool isNew = showQuality(
      {subject.scene.level().bake, bake_, subject.renderer.settings(), settings.canBake}, choice);
  settings.options = choice.options;
  settings.fov = choice.fov;
  settings.frameCap = choice.frameCap;
  return isNew;
}

}  // namespace hearth
