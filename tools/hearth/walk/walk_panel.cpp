#include "hearth/walk/walk_panel.h"

#include "hearth/overlay/lights_section.h"
#include "hearth/overlay/quality_section.h"
#include "hearth/overlay/view_section.h"
#include "hearth/session.h"

namespace hearth {

void WalkPanel::toggle() {
  overlay_.toggle();
  releasePointer();
  if (lights_ && isOpen()) lights()->open();
  comfortSection_.giveUp();
}

void WalkPanel::releasePointer() {
  pointer_.release();
  if (lights_) lights_->release();
}

void WalkPanel::editLights(const std::filesystem::path& file, const LoadLimits& limits) {
  if (lights_ && (lights()->file() == file || lights()->isUnsaved())) return;
  lights_.emplace(file, limits);
}

bool WalkPanel::take(const SDL_Event& event, const PanelScene& scene, Comfort& comfort) {
  if (!isOpen()) return false;
  if (comfortSection_.take(event, comfort)) {
    overlay_.refresh();
    return true;
  }
  point(event, scene);
  if (overlay_.take(event)) return true;
  return lights_ && event.type == SDL_KEYDOWN && lights_->take(event.key);
}

/// What the mouse does in the picture beside the panel is about a light, if it is at one, and else
/// about what shows there.
void WalkPanel::point(const SDL_Event& event, const PanelScene& scene) {
  const int panelLeft = overlay_.hasPopup() ? 0 : overlay_.leaves(scene.size.width);
  const std::optional<PointerEvent> pointed = pointer_.take(event, panelLeft);
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
  const auto sections = [&] {
    showFigures(figures);
    wishes.areOptionsNew = showQualityOf(scene, settings);
    showView(view.mode, view.channel);
    showLights(lights_ ? &*lights_ : nullptr, scene.level, scene.camera);
    wishes.copied = inspector_.show(
        {scene.level, scene.renderer, bake_, scene.source, scene.isLevelShown}, scene.camera);
    wishes.isComfortNew = comfortSection_.show(settings.comfort);
    wishes.bookmark = bookmarksSection_.show(settings.bookmarks, scene.bookmarks);
  };
  overlay_.draw(now, sections, picture);
  return wishes;
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
