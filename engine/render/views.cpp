#include "render/views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "level/plan_bounds.h"
#include "math/check.h"
#include "math/tolerance.h"
#include "render/line.h"
#include "render/renderer.h"
#include "render/screen_edges.h"
#include "render/segment_colors.h"
#include "render/span_groups.h"
#include "render/strip.h"
#include "render/visibility.h"
#include "render/wireframe.h"

namespace hearth {

namespace {

constexpr Rgb kBackground = {16, 18, 28};
constexpr Rgb kAxis = {52, 58, 80};
constexpr Rgb kEye = {96, 200, 255};
constexpr Rgb kFieldOfView = {48, 120, 176};

/// Fraction of the picture's shorter side that stays free round a plan.
constexpr double kMargin = 0.06;

/// Metres of depth. Where 1/depth is drawn, which has no end, what is nearer than authors can mean
/// is left out.
constexpr double kNearPlane = kAuthorNoise;

Rgb dimmed(Rgb color) {
  const auto dim = [](std::uint8_t c) { return static_cast<std::uint8_t>(c / 4 + 16); };
  return {dim(color.r), dim(color.g), dim(color.b)};
}

void drawLine(const PixelRows& picture, Vec2 a, Vec2 b, Rgb color) {
  forEachPixelOfLine(a, b, picture.width, picture.height,
                     [&](int x, int y, double) { *picture.at(x, y) = toXrgb(color); });
}

/// The eye, as a small cross.
void drawEye(const PixelRows& picture, Vec2 p) {
  constexpr double kArm = 3;  // pixels
  drawLine(picture, p - Vec2{kArm, 0}, p + Vec2{kArm, 0}, kEye);
  drawLine(picture, p - Vec2{0, kArm}, p + Vec2{0, kArm}, kEye);
}

bool facesEye(const ViewedLine& segment) {
  // Seen from the front, p0 is on the left.
  return segment.p0.lateral * segment.p1.depth < segment.p1.lateral * segment.p0.depth;
}

// --- World -----------------------------------------------------------------------------------

/// Fits a part of the map into a picture.
struct Fit {
  double scale;  ///< pixels per metre
  Vec2 middle;   ///< of the map
  Vec2 center;   ///< of the picture

  Vec2 operator()(Vec2 world) const { return center + scale * (world - middle); }
};

Fit fitPlan(const Scene& scene, const Camera& camera) {
  Box frame = planBounds(scene.level());
  frame.add(camera.eye.xy());
  const Vec2 size = frame.max - frame.min;
  const double free = 1 - 2 * kMargin;
  const double scale = std::min(camera.width * free / std::max(size.x, kNearPlane),
                                camera.height * free / std::max(size.y, kNearPlane));
  return {scale, frame.min + 0.5 * size, {camera.width / 2.0, camera.height / 2.0}};
}

void drawWorld(const Scene& scene, const Camera& camera, const Projection& projection,
               const PixelRows& picture) {
  const Fit fit = fitPlan(scene, camera);
  const double far = (camera.width + camera.height) / fit.scale;  // metres, past every edge
  const Vec2 origin = fit({0, 0});
  drawLine(picture, {0, origin.y}, {picture.width + 0.0, origin.y}, kAxis);
  drawLine(picture, {origin.x, 0}, {origin.x, picture.height + 0.0}, kAxis);

  const Vec2 eye = camera.eye.xy();
  for (const double column : {0.0, camera.width + 0.0}) {
    const Vec2 ray = projection.rayOf(column);
    drawLine(picture, fit(eye), fit(eye + (far / length(ray)) * ray), kFieldOfView);
  }
  drawLine(picture, fit(eye), fit(eye + far * projection.direction()), kAxis);

  forWallsThenWaysOn(scene, [&](const Segment& segment) {
    drawLine(picture, fit(segment.p0), fit(segment.p1), colorOf(scene, segment));
  });
  const double arrow = 12 / fit.scale;  // metres that 12 pixels are
  drawLine(picture, fit(eye), fit(eye + arrow * projection.direction()), kEye);
  drawEye(picture, fit(eye));
}

// --- Camera ----------------------------------------------------------------------------------

/// How far from the eye things are, ahead and to either side: metres.
struct Extent {
  double depth = 0;
  double lateral = 0;
};

/// Of what lies in the field of view of the segments that count.
template <typename Counts>
Extent extentInView(const Scene& scene, const Projection& projection, double edge,
                    Counts&& counts) {
  Extent extent;
  for (const Segment& segment : scene.level().segments) {
    if (!counts(segment)) continue;
    const ViewedLine seen = viewed(projection, segment.p0, segment.p1, edge, kNearPlane);
    if (!seen.part) continue;
    for (const double fraction : {seen.part->from, seen.part->to}) {
      extent.depth = std::max(extent.depth, seen.at(fraction).depth);
      extent.lateral = std::max(extent.lateral, std::abs(seen.at(fraction).lateral));
    }
  }
  return extent;
}

/// Pixels per metre at which the part of the plan in the field of view fits above the eye; the
/// whole plan if no part of it is there.
double fitView(const Scene& scene, const Camera& camera, const Projection& projection,
               double eyeRow) {
  const double edge = slantOfEdge(camera, projection);
  const Box frame = planBounds(scene.level());
  Extent extent = extentInView(scene, projection, edge, [&](const Segment& segment) {
    return frame.contains(segment.p0) && frame.contains(segment.p1);
  });
  if (extent.depth == 0)
    extent = extentInView(scene, projection, edge, [](const Segment&) { return true; });
  return std::min(eyeRow / std::max(extent.depth, kNearPlane),
                  camera.width / 2.0 / std::max(extent.lateral, kNearPlane)) *
         (1 - kMargin);
}

void drawCamera(const Scene& scene, const Camera& camera, const Projection& projection,
                const PixelRows& picture) {
  const double edge = slantOfEdge(camera, projection);
  const Vec2 eye = {camera.width / 2.0, camera.height * 0.9};
  const double scale = fitView(scene, camera, projection, eye.y);
  const auto toPicture = [&](CameraPoint p) { return eye + scale * Vec2{p.lateral, -p.depth}; };

  const double far = (camera.width + camera.height) / scale;
  drawLine(picture, {0, eye.y}, {picture.width + 0.0, eye.y}, kAxis);
  drawLine(picture, eye, toPicture({far, 0}), kAxis);
  drawLine(picture, eye, toPicture({far, far * edge}), kFieldOfView);
  drawLine(picture, eye, toPicture({far, -far * edge}), kFieldOfView);
  forWallsThenWaysOn(scene, [&](const Segment& segment) {
    drawLine(picture, toPicture(projection.toCamera(segment.p0)),
             toPicture(projection.toCamera(segment.p1)), dimmed(colorOf(scene, segment)));
  });
  forWallsThenWaysOn(scene, [&](const Segment& segment) {
    const ViewedLine seen = viewed(projection, segment.p0, segment.p1, edge, kNearPlane);
    if (seen.part)
      drawLine(picture, toPicture(seen.at(seen.part->from)), toPicture(seen.at(seen.part->to)),
               colorOf(scene, segment));
  });
  drawEye(picture, eye);
}

// --- What is in view -------------------------------------------------------------------------

/// What a pixel shows: a surface of which sector, and how far away that can be.
struct Shown {
  SectorId sector;
  double depth = 0;  ///< metres; 0 where nothing shows
};

/// The frame that the renderer would draw, as sectors and depths.
class ShownPixels {
 public:
  ShownPixels(const Scene& scene, const Camera& camera, const Projection& projection)
      : width_(camera.width),
        height_(camera.height),
        pixels_(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height)),
        seenSectors_(scene.level().sectors.size(), false) {
    seenSectors_[camera.sector.index()] = true;
    VisibilityScratch scratch;
    const VisibleSpans& found = findVisibleSpans(scene, camera, projection, scratch);
    for (int strip = 0; strip < Strip::countIn(camera.width); ++strip)
      found.forEachGroup(strip, [&](const auto& group) {
        group.forEachSpan([&](const Span& span) { note(span, scene[span.surface].sector); });
      });
  }

  bool isSeen(SectorId sector) const { return seenSectors_[sector.index()]; }

  /// Whether a point of a wall of the sector shows: at its pixel or beside it there is air of that
  /// sector which reaches as deep.
  bool shows(int x, int y, SectorId sector, double depth) const {
    for (int row = std::max(0, y - 1); row <= std::min(height_ - 1, y + 1); ++row)
      for (int column = std::max(0, x - 1); column <= std::min(width_ - 1, x + 1); ++column) {
        const Shown& pixel = pixels_[index(column, row)];
        constexpr double kSlack = 0.98;  // depth changes within the pixel
        if (pixel.sector == sector && pixel.depth >= kSlack * depth) return true;
      }
    return false;
  }

 private:
  void note(const Span& span, SectorId sector) {
    seenSectors_[sector.index()] = true;
    for (int row = span.rowBegin; row < span.rowEnd; ++row)
      pixels_[index(span.column, row)] = {sector, span.depth};
  }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_;
  int height_;
  std::vector<Shown> pixels_;
  std::vector<bool> seenSectors_;
};

/// Calls `draw(segment, viewed)` for the segments in view: in the field of view, from their front,
/// of sectors of which something shows.
template <typename Draw>
void forSegmentsInView(const Scene& scene, const Camera& camera, const Projection& projection,
                       const ShownPixels& shown, double nearPlane, Draw&& draw) {
  const double edge = slantOfEdge(camera, projection);
  forWallsThenWaysOn(scene, [&](const Segment& segment) {
    if (!shown.isSeen(segment.sector)) return;
    const ViewedLine seen = viewed(projection, segment.p0, segment.p1, edge, nearPlane);
    if (seen.part && facesEye(seen)) draw(segment, seen);
  });
}

// --- Depth space -----------------------------------------------------------------------------

void drawDepthSpace(const Scene& scene, const Camera& camera, const Projection& projection,
                    const PixelRows& picture) {
  const ShownPixels shown(scene, camera, projection);
  double nearest = 0;  // the greatest 1/depth, which goes to the lower edge
  forSegmentsInView(scene, camera, projection, shown, kNearPlane,
                    [&](const Segment&, const ViewedLine& seen) {
                      for (const double fraction : {seen.part->from, seen.part->to})
                        nearest = std::max(nearest, 1 / seen.at(fraction).depth);
                    });

  const double top = kMargin * camera.height;  // where 1/depth is 0
  const double scale = nearest > 0 ? (camera.height - 2 * top) / nearest : 0;
  drawLine(picture, {0, top}, {picture.width + 0.0, top}, kAxis);
  drawLine(picture, {camera.width / 2.0, 0}, {camera.width / 2.0, picture.height + 0.0}, kAxis);
  forSegmentsInView(scene, camera, projection, shown, kNearPlane,
                    [&](const Segment& segment, const ViewedLine& seen) {
                      const auto toPicture = [&](double fraction) {
                        const CameraPoint p = seen.at(fraction);
                        return Vec2{projection.columnOf(p), top + scale / p.depth};
                      };
                      drawLine(picture, toPicture(seen.part->from), toPicture(seen.part->to),
                               colorOf(scene, segment));
                    });
}

// --- Screen ----------------------------------------------------------------------------------

/// Dim where something hides an edge.
void drawScreen(const Scene& scene, const Camera& camera, const Projection& projection,
                const PixelRows& picture) {
  const ShownPixels shown(scene, camera, projection);
  const auto draw = [&](const Segment& segment, const ViewedLine& seen) {
    plotEdges(scene, projection, camera, segment, seen, [&](int x, int y, double depth, Rgb color) {
      std::uint32_t& pixel = *picture.at(x, y);
      if (shown.shows(x, y, segment.sector, depth))
        pixel = toXrgb(color);
      else if (pixel == toXrgb(kBackground))
        pixel = toXrgb(dimmed(color));
    });
  };
  forSegmentsInView(scene, camera, projection, shown, kNearPlaneOfScreen, draw);
}

}  // namespace

void drawView(const Scene& scene, const Camera& camera, View view, const PixelRows& picture) {
  CHECK(picture.width == camera.width && picture.height == camera.height, picture.width,
        picture.height, camera.width, camera.height);
  picture.fill(view == View::Wireframe ? Rgb{} : kBackground);
  const Projection projection = projectionFor(scene, camera);
  switch (view) {
    case View::World:
      return drawWorld(scene, camera, projection, picture);
    case View::Camera:
      return drawCamera(scene, camera, projection, picture);
    case View::DepthSpace:
      return drawDepthSpace(scene, camera, projection, picture);
    case View::Screen:
      return drawScreen(scene, camera, projection, picture);
    case View::Wireframe:
      return drawWireframe(scene, camera, projection, picture);
  }
}

Image drawView(const Scene& scene, const Camera& camera, View view) {
  PixelBuffer memory;
  const PixelRows picture = memory.rows(camera.width, camera.height);
  drawView(scene, camera, view, picture);
  return imageOf(picture);
}

}  // namespace hearth
