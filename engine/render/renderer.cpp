#include "render/renderer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>

#include "level/locate.h"
#include "math/check.h"
#include "math/parallel.h"
#include "render/channel_pixels.h"
#include "render/marks.h"
#include "render/ray_slopes.h"
#include "render/shown_columns.h"
#include "render/span_painter.h"
#include "render/visibility.h"

namespace hearth {

namespace {

/// Into how many parts threads divide so many strips: several to each thread, so that none has to
/// wait long for one whose strips are dearer.
int partsOf(int strips, const Workers* workers) {
  constexpr int kPartsPerThread = 4;
  const int threads = workers ? workers->threads() : 1;
  return threads == 1 ? 1 : std::min(strips, kPartsPerThread * threads);
}

/// The first strip of one of these parts. That of the part behind the last is the number of strips.
int firstStripOf(int part, int parts, int strips) {
  return static_cast<int>(std::int64_t{strips} * part / parts);
}

/// Calls work(i) for all parts of a frame.
template <typename Work>
void runAll(std::size_t parts, Workers* workers, const Work& work) {
  if (workers)
    workers->run(parts, std::cref(work));  // by reference: a copy would take memory in every frame
  else
    for (std::size_t i = 0; i < parts; ++i) work(i);
}

/// How many squares of pixels cover so many pixels.
int squaresIn(int pixels, int pixelSize) { return (pixels + pixelSize - 1) / pixelSize; }

void checkSize(const PixelRows& picture, const Camera& camera) {
  CHECK(picture.width == camera.width && picture.height == camera.height, picture.width,
        picture.height, camera.width, camera.height);
}

/// A picture of its own, which `draw(scratch, rows)` draws.
template <typename Draw>
Image singlePicture(const Camera& camera, Draw&& draw) {
  FrameScratch scratch;
  PixelBuffer memory;
  const PixelRows picture = memory.rows(camera.width, camera.height);
  draw(scratch, picture);
  return imageOf(picture);
}

/// Into parts of about as many strips, which threads take.
void divideColumns(std::vector<FrameColumns>& parts, int width, const Workers* workers) {
  const int strips = Strip::countIn(width);
  const int count = partsOf(strips, workers);
  parts.resize(static_cast<std::size_t>(count));
  const auto columnOf = [&](int part) {
    return std::min(width, firstStripOf(part, count, strips) * Strip::kColumns);
  };
  for (int i = 0; i < count; ++i)
    parts[static_cast<std::size_t>(i)].range = {columnOf(i), columnOf(i + 1)};
}

/// Strips [begin, end) of a picture.
struct StripRange {
  int begin;
  int end;
};

/// Calls `paintPart(range, strips, stats)` for parts of a picture of so many strips, which threads
/// take: neighbouring strips, some of them at a time drawn in `strips`.
template <typename PaintPart>
void paintParts(FrameScratch& scratch, int strips, Workers* workers, PaintPart&& paintPart) {
  const int parts = partsOf(strips, workers);
  if (scratch.strips.size() < static_cast<std::size_t>(parts))
    scratch.strips.resize(static_cast<std::size_t>(parts));
  scratch.stripsPainted.assign(static_cast<std::size_t>(parts), {});
  const auto paint = [&](std::size_t part) {
    const auto i = static_cast<int>(part);
    PaintStats stats;
    paintPart(StripRange{firstStripOf(i, parts, strips), firstStripOf(i + 1, parts, strips)},
              scratch.strips[part], stats);
    scratch.stripsPainted[part] = stats;
  };
  runAll(static_cast<std::size_t>(parts), workers, paint);
  scratch.painted = {};
  for (const PaintStats& stats : scratch.stripsPainted) scratch.painted += stats;
}

/// Draws strips with `paintStrip(index, strip)`, and copies them to the picture.
template <typename PaintStrip>
void paintRange(StripRange range, StripsTogether& strips, const PixelRows& picture, int pixelSize,
                PaintStrip&& paintStrip) {
  for (int first = range.begin; first < range.end; first += static_cast<int>(kStripsTogether)) {
    const auto count = static_cast<std::size_t>(range.end - first);
    const std::span<Strip> next = std::span(strips).first(std::min(kStripsTogether, count));
    int index = first;
    for (Strip& strip : next) paintStrip(index++, strip);
    copyStrips(next, picture, pixelSize);
  }
}

/// Draws a picture strip by strip, with `paint(group, block, strip, stats)` for each group of
/// spans. Strips that spans fill begin as they happen to be, unless `paint` reads what was there.
template <typename Paint>
void paintStrips(FrameScratch& scratch, int pixelSize, const PixelRows& picture, Workers* workers,
                 bool readsBefore, Paint&& paint) {
  const int strips = Strip::countIn(squaresIn(picture.width, pixelSize));
  const int rows = squaresIn(picture.height, pixelSize);
  paintParts(
      scratch, strips, workers, [&](StripRange range, StripsTogether& together, PaintStats& stats) {
        PixelBlock block{};
        paintRange(range, together, picture, pixelSize, [&](int i, Strip& strip) {
          if (!readsBefore && scratch.isFilled(i, rows))
            strip.begin(i, rows);
          else
            strip.begin(i, rows, kHole);
          scratch.forEachGroup(i, [&](const auto& group) { paint(group, block, strip, stats); });
        });
      });
}

/// Lights one strip, for marks: on holes where nothing is drawn.
void paintLit(const SpanPainter& painter, const FrameScratch& scratch, int index, int rows,
              PixelBlock& block, Strip& strip, PaintStats& stats) {
  strip.begin(index, rows, kHole);
  scratch.forEachGroup(index, [&](const auto& group) {
    painter.paint(group, LightMode::Both, block, strip, stats);
  });
}

/// What the spans of a column show.
template <typename Shown>
void noteColumn(const SpanPainter& painter, const FrameScratch& scratch, int column,
                ShownColumns<Shown>& shown) {
  shown.next();
  scratch.forEachGroup(column / Strip::kColumns, [&](const auto& group) {
    group.forEachSpan([&](const Span& span) {
      if (span.column == column) noteShown(painter, span, scratch.raySlopes, shown.here());
    });
  });
}

/// Marks what is lit already.
template <typename Shown>
void paintMarked(const Scene& scene, const SpanPainter& painter, FrameScratch& scratch,
                 const PixelRows& picture, Workers* workers) {
  const int strips = Strip::countIn(picture.width);
  paintParts(scratch, strips, workers,
             [&](StripRange range, StripsTogether& together, PaintStats& stats) {
               PixelBlock block{};
               ShownColumns<Shown> shown(picture.height);
               if (range.begin > 0)
                 noteColumn(painter, scratch, range.begin * Strip::kColumns - 1, shown);
               paintRange(range, together, picture, 1, [&](int i, Strip& strip) {
                 paintLit(painter, scratch, i, picture.height, block, strip, stats);
                 const int end = std::min((i + 1) * Strip::kColumns, picture.width);
                 for (int column = i * Strip::kColumns; column < end; ++column) {
                   noteColumn(painter, scratch, column, shown);
                   mark(scene, shown, strip, column);
                 }
               });
             });
}

/// Likewise with dots, which may reach into the next column: each part draws what lies in its own
/// columns.
void paintVertices(const SpanPainter& painter, const Projection& projection, FrameScratch& scratch,
                   const PixelRows& picture, Workers* workers) {
  const int strips = Strip::countIn(picture.width);
  paintParts(scratch, strips, workers,
             [&](StripRange range, StripsTogether& together, PaintStats& stats) {
               PixelBlock block{};
               paintRange(range, together, picture, 1, [&](int i, Strip& strip) {
                 paintLit(painter, scratch, i, picture.height, block, strip, stats);
               });
               const ColumnRange own{range.begin * Strip::kColumns,
                                     std::min(range.end * Strip::kColumns, picture.width)};
               ShownColumns<ShownFace> shown(picture.height);
               const int end = std::min(own.end + kDotRadius, picture.width);
               for (int column = std::max(own.begin - kDotRadius, 0); column < end; ++column) {
                 noteColumn(painter, scratch, column, shown);
                 markVertices(projection, shown.here(), column, own, picture);
               }
             });
}

}  // namespace

Projection projectionFor(const Scene& scene, const Camera& camera, int pixelSize) {
  return Projection(camera, nudgedInside(scene, scene[camera.sector], camera.eye), pixelSize);
}

Camera inSquares(Camera camera, int pixelSize) {
  camera.width = squaresIn(camera.width, pixelSize);
  camera.height = squaresIn(camera.height, pixelSize);
  return camera;
}

DrawnTextures drawnTextures(const std::vector<Image>& images, TextureFilter filter) {
  std::vector<MipMap> textures;
  textures.reserve(images.size());
  for (const Image& image : images)
    textures.push_back(filter == TextureFilter::Mipmapped ? MipMap::withAllSizes(image)
                                                          : MipMap(image));
  return std::make_shared<const std::vector<MipMap>>(std::move(textures));
}

Renderer::Renderer(const Scene& scene, DrawnTextures textures, const BakedLight& light,
                   DrawSettings settings)
    : scene_(scene),
      sprites_(scene.level()),
      textures_(std::move(textures)),
      light_(light),
      glow_(scene.level()),
      settings_(settings) {}

Renderer::Renderer(const Scene& scene, const std::vector<Image>& images, const BakedLight& light,
                   DrawSettings settings)
    : Renderer(scene, drawnTextures(images, settings.textureFilter), light, settings) {}

void Renderer::draw(const Camera& camera, LightMode mode, FrameScratch& scratch,
                    const PixelRows& picture, Workers* workers) const {
  findSpans(camera, scratch, workers);
  paintSpans(camera, mode, scratch, picture, workers);
}

void Renderer::findSpans(const Camera& camera, FrameScratch& scratch, Workers* workers) const {
  findSpans(camera, settings_.pixelSize, scratch, workers);
}

void Renderer::paintSpans(const Camera& camera, LightMode mode, FrameScratch& scratch,
                          const PixelRows& picture, Workers* workers) const {
  checkSize(picture, camera);
  const int pixelSize = settings_.pixelSize;
  const Projection projection = projectionFor(scene_, camera, pixelSize);
  const SpanPainter painter(scene_, *textures_, light_, glow_, settings_, projection,
                            scratch.raySlopes);
  paintStrips(scratch, pixelSize, picture, workers, false,
              [&](const auto& group, PixelBlock& block, Strip& strip, PaintStats& stats) {
                painter.paint(group, mode, block, strip, stats);
              });
}

void Renderer::draw(const Camera& camera, Channel channel, FrameScratch& scratch,
                    const PixelRows& picture, Workers* workers) const {
  checkSize(picture, camera);
  findSpans(camera, 1, scratch, workers);
  const Projection projection = projectionFor(scene_, camera);
  const SpanPainter painter(scene_, *textures_, light_, glow_, settings_, projection,
                            scratch.raySlopes);
  std::vector<std::size_t> numbers;
  if (channel == Channel::Surface || channel == Channel::Faces) numbers = numbersOfShown(scene_);
  const ChannelFrame frame{channel, scene_.level(), projection.eye(), numbers, scratch.raySlopes};
  paintStrips(
      scratch, 1, picture, workers, true,
      [&](const auto& group, PixelBlock&, Strip& strip, PaintStats&) {
        group.forEachSpan([&](const Span& span) { paintChannel(painter, span, frame, strip); });
      });
}

void Renderer::draw(const Camera& camera, Marks marks, FrameScratch& scratch,
                    const PixelRows& picture, Workers* workers) const {
  checkSize(picture, camera);
  findSpans(camera, 1, scratch, workers);
  const Projection projection = projectionFor(scene_, camera);
  const SpanPainter painter(scene_, *textures_, light_, glow_, settings_, projection,
                            scratch.raySlopes);
  switch (marks) {
    case Marks::Texels:
      paintMarked<ShownTexel>(scene_, painter, scratch, picture, workers);
      break;
    case Marks::Outlines:
      paintMarked<ShownSurface>(scene_, painter, scratch, picture, workers);
      break;
    case Marks::Coverage:
      paintMarked<ShownTimes>(scene_, painter, scratch, picture, workers);
      break;
    case Marks::Vertices:
      paintVertices(painter, projection, scratch, picture, workers);
      break;
  }
}

Image Renderer::draw(const Camera& camera, LightMode mode) const {
  return singlePicture(camera, [&](FrameScratch& scratch, const PixelRows& picture) {
    draw(camera, mode, scratch, picture);
  });
}

Image Renderer::draw(const Camera& camera, Channel channel, Workers* workers) const {
  return singlePicture(camera, [&](FrameScratch& scratch, const PixelRows& picture) {
    draw(camera, channel, scratch, picture, workers);
  });
}

Image Renderer::draw(const Camera& camera, Marks marks, Workers* workers) const {
  return singlePicture(camera, [&](FrameScratch& scratch, const PixelRows& picture) {
    draw(camera, marks, scratch, picture, workers);
  });
}

void Renderer::findSpans(const Camera& camera, int pixelSize, FrameScratch& scratch,
                         Workers* workers) const {
  const Projection projection = projectionFor(scene_, camera, pixelSize);
  const Camera squares = inSquares(camera, pixelSize);
  divideColumns(scratch.parts, squares.width, workers);
  const auto findPart = [&](std::size_t i) {
    FrameColumns& part = scratch.parts[i];
    findVisibleSpans(scene_, sprites_, squares, projection, part.range, part.visibility);
  };
  runAll(scratch.parts.size(), workers, findPart);
  findRaySlopes(projection, squares.height + PixelBlock::kSpareRows, scratch.raySlopes);
}

}  // namespace hearth
