#include "viewer/walk/frame_painter.h"

#include <cstdint>

#include "settings/channels.h"

namespace hearth {

Workers* workersFor(ImageSize picture, Workers* workers) {
  constexpr std::int64_t kFewPixels = 128'000;
  return std::int64_t{picture.width} * picture.height < kFewPixels ? nullptr : workers;
}

void FramePainter::continueIn(const Scene& scene, const Renderer& renderer) {
  scene_ = scene;
  renderer_ = &renderer;
  seen_ = SeenSectors(scene.level(), seen_);
}

void FramePainter::find(const WalkFrame& frame) {
  renderer_->findSpans(frame.camera, scratch_, workersFor(frame.size, workers_));
}

void FramePainter::paint(const WalkFrame& frame, const PixelRows& picture) {
  Workers* const workers = workersFor(frame.size, workers_);
  const WalkView& view = frame.view;
  if (view.channel.empty())
    renderer_->paintSpans(frame.camera, view.mode, scratch_, picture, workers);
  else
    drawChannel(scene_, *renderer_, frame.camera, view.channel, scratch_, picture, workers);
}

void FramePainter::noteSeen(const WalkFrame& frame, SectorId player) {
  seen_.add(frame.camera.sector);
  seen_.add(player);
  // Of a sprite that reaches into a sector, its own may be out of sight.
  scratch_.forEachSpan([this](const Span& span) {
    if (!span.view) seen_.add(span);
  });
}

void FramePainter::drawMap(const WalkFrame& frame, const PixelRows& picture) const {
  drawAutomap(picture, scene_, seen_, frame.eye, frame.view.mapMetres);
}

FrameCounters FramePainter::counters(const WalkFrame& frame) const {
  const bool isPainted = frame.view.channel.empty();  // span by span, as is counted
  return countersOf(scratch_.found(), isPainted ? scratch_.painted : PaintStats{});
}

}  // namespace hearth
