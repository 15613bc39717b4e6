#include "render/renderer.h"

#include <algorithm>
#include <cstddef>
#include <functional>

#include "level/locate.h"
#include "light/parallel.h"
#include "render/channel_pixels.h"
#include "render/span_painter.h"
#include "render/visibility.h"

namespace hearth {

namespace {

/// So that no thread has to wait long for one whose strips are dearer.
constexpr int kPartsPerThread = 4;

void findClimbs(std::vector<double>& climbs, const Projection& projection, int height) {
  climbs.clear();
  const int rows = height + static_cast<int>(RowBatch::kMostLanes);
  for (int row = 0; row < rows; ++row) climbs.push_back(projection.climbOf(row + 0.5));
}

/// Draws a picture strip by strip, with `paint(span, strip, stats)` for each span. Threads take
/// parts: neighbouring strips, drawn one after the other in the same memory.
template <typename Paint>
void paintStrips(FrameScratch& scratch, Image& picture, int threads, Paint&& paint) {
  const int strips = Strip::countIn(picture.width());
  const int parts = threads == 1 ? 1 : std::min(strips, kPartsPerThread * threads);
  if (scratch.strips.size() < static_cast<std::size_t>(parts))
    scratch.strips.resize(static_cast<std::size_t>(parts));
  scratch.stripsPainted.assign(static_cast<std::size_t>(parts), {});
  const auto firstOf = [&](std::size_t part) {
    return static_cast<int>(static_cast<std::size_t>(strips) * part /
                            static_cast<std::size_t>(parts));
  };
  const auto paintPart = [&](std::size_t part) {
    Strip& strip = scratch.strips[part];
    RowBatch batch{};
    PaintStats stats;
    for (int i = firstOf(part); i < firstOf(part + 1); ++i) {
      strip.begin(i, picture.height(), kHole);
      for (const Span& span : scratch.stripSpans.of(i)) paint(span, batch, strip, stats);
      strip.copyTo(picture);
    }
    scratch.stripsPainted[part] = stats;
  };
  // By reference: a copy would take memory in every frame.
  parallelFor(static_cast<std::size_t>(parts), threads, std::cref(paintPart));
  scratch.painted = {};
  for (const PaintStats& stats : scratch.stripsPainted) scratch.painted += stats;
}

}  // namespace

Projection projectionFor(const Level& level, const Camera& camera) {
  return Projection(camera, nudgedInside(level, level[camera.sector], camera.eye));
}

void Renderer::draw(const Camera& camera, LightMode mode, FrameScratch& scratch, Image& picture,
                    int threads) const {
  const Projection projection = projectionFor(level_, camera);
  findSpans(camera, projection, scratch, picture);
  const SpanPainter painter(level_, textures_, light_, settings_, projection, scratch.climbs);
  paintStrips(scratch, picture, threads,
              [&](const Span& span, RowBatch& batch, Strip& strip, PaintStats& stats) {
                painter.paint(span, mode, batch, strip, stats);
              });
}

Image Renderer::draw(const Camera& camera, LightMode mode) const {
  FrameScratch scratch;
  Image picture;
  draw(camera, mode, scratch, picture);
  return picture;
}

Image Renderer::draw(const Camera& camera, Channel channel) const {
  FrameScratch scratch;
  Image picture;
  const Projection projection = projectionFor(level_, camera);
  findSpans(camera, projection, scratch, picture);
  const SpanPainter painter(level_, textures_, light_, settings_, projection, scratch.climbs);
  paintStrips(scratch, picture, 1, [&](const Span& span, RowBatch&, Strip& strip, PaintStats&) {
    paintChannel(painter, span, channel, scratch.climbs, strip);
  });
  return picture;
}

void Renderer::findSpans(const Camera& camera, const Projection& projection, FrameScratch& scratch,
                         Image& picture) const {
  if (picture.width() != camera.width || picture.height() != camera.height)
    picture = Image(camera.width, camera.height);
  scratch.stripSpans.sort(findVisibleSpans(level_, camera, projection, scratch.visibility).spans,
                          camera.width);
  findClimbs(scratch.climbs, projection, camera.height);
}

}  // namespace hearth
