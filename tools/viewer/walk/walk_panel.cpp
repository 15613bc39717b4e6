#include "viewer/walk/walk_panel.h"

#include <vector>

#include "settings/settings.h"
#include "viewer/overlay/drag_axes.h"
#include "viewer/overlay/lights_section.h"
#include "viewer/overlay/model_section.h"
#include "viewer/overlay/quality_section.h"
#include "viewer/overlay/view_section.h"

namespace hearth {

namespace {

constexpr const char* kLightTab = "Light";

}  // namespace

void WalkPanel::toggle() {
  overlay_.toggle();
  releasePointer();
  if (lightsTool_ && isOpen()) lightsEditor()->open();
  preferencesSection_.giveUp();
  moversSection_.giveUp();
}

void WalkPanel::releasePointer() {
  pointer_.release();
  moversSection_.release();
  if (lightsTool_) lightsTool_->release();
}

void WalkPanel::forget() {
  inspector_.forget();
  moversSection_.forget();
}

void WalkPanel::editLights(Storage& storage, const std::filesystem::path& file,
                           const LoadLimits& limits) {
  if (lightsTool_ && (lightsEditor()->file() == file || lightsEditor()->isUnsaved())) return;
  lightsTool_.emplace(storage, file, limits);
}

bool WalkPanel::handle(const Event& event, const PanelSubject& subject, Preferences& preferences) {
  if (!isOpen()) return false;
  if (preferencesSection_.handle(event, preferences)) {
    overlay_.refresh();
    return true;
  }
  handlePointer(event, subject);
  const auto* key = std::get_if<KeyEvent>(&event);
  const KeyEvent* const pressed = lightsTool_ && key && key->isDown ? key : nullptr;
  if (pressed && LightsTool::isSave(*pressed)) {
    overlay_.refresh();
    return lightsTool_->handle(*pressed, subject.scene);
  }
  if (overlay_.handle(event)) return true;
  return pressed && lightsTool_->handle(*pressed, subject.scene);
}

/// Handles what the mouse does in the picture beside the panel. It is about a light if the mouse is
/// at one. Otherwise it is about what shows there.
void WalkPanel::handlePointer(const Event& event, const PanelSubject& subject) {
  const int panelLeft = overlay_.hasPopup() ? 0 : overlay_.widthBeside(subject.size.width);
  const std::optional<PointerEvent> pointed = pointer_.handle(event, panelLeft);
  if (pointed && pointed->kind == PointerEvent::Kind::Press) tabs_.turnTo(kLightTab);
  const bool isOfLight = pointed && subject.space && lightsTool_ &&
                         lightsTool_->handle(*pointed, *subject.space, subject.camera.height);
  inspector_.handle(event, subject.isLevelShown && !isOfLight ? panelLeft : 0);
}

void WalkPanel::drawMarks(const PanelSubject& subject, const PixelRows& picture) const {
  if (isOpen() && lightsTool_ && subject.space)
    lightsTool_->draw(subject.scene, subject.camera, *subject.space, picture);
}

PanelRequests WalkPanel::draw(double now, const PanelSubject& subject, const Figures& figures,
                              WalkSettings& settings, WalkView& view, const PixelRows& picture) {
  PanelRequests requests;
  if (!isOpen()) return requests;
  if (settings.canBake) bake_ = bakeSettingsFrom(subject.scene, settings.options);
  const std::vector<Tab> tabs = tabsFor(subject, figures, settings, view, requests);
  overlay_.draw(
      now, [&] { tabs_.show(tabs); }, picture);
  return requests;
}

/// What they show goes into the settings, the view and the requests.
std::vector<Tab> WalkPanel::tabsFor(const PanelSubject& subject, const Figures& figures,
                                    WalkSettings& settings, WalkView& view,
                                    PanelRequests& requests) {
  std::vector<Tab> tabs = {
      {kLightTab, [&] { requests.copied = showLightTab(subject); }},
      {"View", [&] { showView(view.mode, view.channel); }},
      {"Quality", [&] { requests.optionsChanged = showQualityTab(subject, settings); }},
      {"Figures", [&] { showFigures(figures); }},
      {"Preferences",
       [&] { requests.preferencesChanged = preferencesSection_.show(settings.preferences); }},
  };
  if (subject.model)
    tabs.insert(tabs.begin(), {"Model", [&] { showModel(*subject.model); }});
  else
    tabs.push_back({"Bookmarks", [&] {
                      requests.bookmark =
                          bookmarksSection_.show(settings.bookmarks, subject.bookmarks);
                    }});
  if (!subject.scene.level().movers.empty())
    tabs.push_back({"Movers", [&] {
                      requests.mover =
                          moversSection_.show({subject.scene, subject.moverShares, subject.movers});
                    }});
  return tabs;
}

/// Returns the text to copy to the clipboard, if any.
std::optional<std::string> WalkPanel::showLightTab(const PanelSubject& subject) {
  LightsTool* const lights = lightsTool_ ? &*lightsTool_ : nullptr;
  auto copied = inspector_.show(
      {subject.scene, subject.renderer, bake_, subject.source, lights, subject.isLevelShown},
      subject.camera);
  if (!subject.model) showLights(lights, subject.scene, subject.camera);
  if (lights && subject.space) drawDragAxes(*lights, *subject.space, subject.size.height);
  return copied;
}

bool WalkPanel::showQualityTab(const PanelSubject& subject, WalkSettings& settings) {
  QualityChoice choice{settings.options, settings.fov, settings.frameCap};
  const bool isNew = showQuality({subject.scene.level().bake, bake_, subject.renderer.settings(),
                                  moverLightFrom(settings.options), settings.canBake},
                                 choice);
  settings.options = choice.options;
  settings.fov = choice.fov;
  settings.frameCap = choice.frameCap;
  return isNew;
}

}  // namespace hearth
