#include "viewer/walk/walk_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "viewer/overlay/captions.h"

namespace hearth {

namespace {

/// The longest rest: ticks that are due must not wait for a frame.
constexpr double kTickSeconds = 1.0 / kTicksPerSecond;

}  // namespace

WalkScreen::WalkScreen(const Scene& scene, const Renderer& renderer, const WalkSession& session,
                       const WalkHost& host)
    : scene_(scene),
      session_(session),
      window_(host.window),
      screenshots_(host.screenshots),
      painter_(scene, renderer, host.workers) {
  title_.reserve(scene.level().name.size() + 64);  // so that no frame has to
  window_.setTitle(scene.level().name);
}

void WalkScreen::continueIn(const Scene& scene, const Renderer& renderer) {
  scene_ = scene;
  painter_.continueIn(scene, renderer);
  redraw();
}

void WalkScreen::keepNext() {
  keepsNext_ = true;
  redraw();
}

PanelRequests WalkScreen::show(WalkFrame& frame, const PanelSubject& subject, WalkPanel& panel,
                               WalkSettings& settings, double now) {
  PanelRequests requests;
  if (!window_.windowSize() || (isShown_ && last_ == frame && !panel.isStale(now))) {
    window_.rest(kTickSeconds);
    return requests;
  }
  if (const double left = pacer_.secondsLeft(now, settings.frameCap); left > 0) {
    window_.rest(std::min(left, kTickSeconds));
    return requests;
  }
  last_ = frame;  // which the panel may change; so no frame takes memory
  isShown_ = true;
  if (isCovered(frame, panel))
    requests = drawCovered(frame, subject, panel, settings, now);
  else
    drawUncovered(frame, now);
  return requests;
}

/// Whether a frame is kept as a picture, or something is drawn over it.
bool WalkScreen::isCovered(const WalkFrame& frame, const WalkPanel& panel) const {
  const WalkView& view = frame.view;
  return keepsNext_ || panel.isOpen() || view.isMapShown || view.areKeysShown ||
         !view.channel.empty() || !frame.notes.empty() || !frame.message.empty();
}

/// Straight into the window's memory.
void WalkScreen::drawUncovered(const WalkFrame& frame, double now) {
  const auto draw = [&](const PixelRows& rows) {
    painter_.find(frame);
    painter_.paint(frame, rows);
    painter_.noteSeen(frame, session_.walker().sector);
    count(now, window_.seconds());
  };
  window_.show(frame.size, std::cref(draw));  // a reference takes no memory
}

/// In memory of its own: a window's is not to be read.
PanelRequests WalkScreen::drawCovered(WalkFrame& frame, const PanelSubject& subject,
                                      WalkPanel& panel, WalkSettings& settings, double now) {
  FrameParts parts;
  double begin = window_.seconds();
  const auto lap = [&] {
    const double end = window_.seconds();
    return end - std::exchange(begin, end);
  };
  const auto [width, height] = frame.size;
  const PixelRows picture = memory_.rows(width, height);
  const PixelRows ofCamera = picture.part(0, 0, frame.camera.width, height);
  painter_.find(frame);
  parts.find = lap();
  painter_.paint(frame, ofCamera);
  parts.paint = lap();
  keepScreenshot(frame, ofCamera);
  picture.part(ofCamera.width, 0, width - ofCamera.width, height).fill({});
  painter_.noteSeen(frame, session_.walker().sector);
  drawCaptions(frame, subject, panel, settings.preferences, picture);
  figures_.counters = painter_.counters(frame);
  figures_.lightmapBytes = renderer().light().stats.bytes;
  figures_.residentBytes = window_.residentBytes();
  PanelRequests requests = panel.draw(now, subject, figures_, settings, frame.view, picture);
  parts.cover = lap();
  count(now, begin);
  window_.show(frame.size, [&](const PixelRows& rows) { copy(picture, rows); });
  parts.show = lap();
  figures_.frames.add(parts);
  return requests;
}

void WalkScreen::keepScreenshot(const WalkFrame& frame, const PixelRows& picture) {
  if (!std::exchange(keepsNext_, false)) return;
  screenshots_.take(imageOf(picture), shotOptionsOf(frame, scene_.level(), renderer().settings()));
}

/// The list of keys and the panel would be in each other's way.
void WalkScreen::drawCaptions(const WalkFrame& frame, const PanelSubject& subject,
                              const WalkPanel& panel, const Preferences& preferences,
                              const PixelRows& picture) const {
  if (frame.view.isMapShown) painter_.drawMap(frame, picture);
  panel.drawMarks(subject, picture);
  if (frame.view.areKeysShown && !panel.isOpen())
    drawKeys(picture, subject.model ? modelKeyList(preferences.keys) : keyList(preferences.keys));
  const int width = panel.widthBeside(picture.width);
  if (!frame.notes.empty() && width > 0) drawNotes(picture, frame.notes, width);
  if (!frame.message.empty()) drawMessage(picture, frame.message);
}

void WalkScreen::count(double begin, double end) {
  const auto mean = rate_.count(begin, end);
  if (!mean) return;
  title_.clear();
  fmt::format_to(std::back_inserter(title_), "{} - {:.1f} ms, {:.0f} frames/s", scene_.level().name,
                 1e3 * mean->drawSeconds, mean->framesPerSecond);
  window_.setTitle(title_);
}

}  // namespace hearth
