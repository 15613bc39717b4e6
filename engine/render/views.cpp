#include "render/views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "level/openings.h"
#include "level/plan_bounds.h"
#include "math/check.h"
#include "math/tolerance.h"
#include "render/line.h"
#include "render/renderer.h"
#include "render/segment_colors.h"
#include "render/visibility.h"

namespace hearth {

namespace {

constexpr Rgb kBackground = {16, 18, 28};
constexpr Rgb kAxis = {52, 58, 80};
constexpr Rgb kEye = {96, 200, 255};
constexpr Rgb kFieldOfView = {48, 120, 176};

/// Fraction of the picture's shorter side that stays free round a plan.
constexpr double kMargin = 0.06;

/// Metres of depth. Where 1/depth is drawn, which has no end, what is nearer than authors can mean
/// is left out; on the screen, what is nearer than any wall is wide.
constexpr double kNearPlane = kAuthorNoise;
constexpr double kNearPlaneOfScreen = kShortestWall;

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

/// Walls that lead on come last: they stay visible where they share a line with others.
template <typename Draw>
void forWallsThenWaysOn(const Scene& scene, Draw&& draw) {
  for (const bool areOpen : {false, true})
    for (const Segment& segment : scene.level().segments)
      if (leadsOn(scene, segment) == areOpen) draw(segment);
}

/// Half the width of the field of view at a depth of one metre.
double slantOfEdge(const Camera& camera, const Projection& projection) {
  return camera.width / 2.0 / projection.distancePx();
}

/// A segment in camera space and the part of it that lies in the field of view.
struct ViewedSegment {
  CameraPoint p0;
  CameraPoint p1;
  std::optional<LinePart> part;

  CameraPoint at(double fraction) const {
    return {std::lerp(p0.depth, p1.depth, fraction), std::lerp(p0.lateral, p1.lateral, fraction)};
  }
};

ViewedSegment viewed(const Projection& projection, const Segment& segment, double edge,
                     double nearPlane) {
  ViewedSegment result{projection.toCamera(segment.p0), projection.toCamera(segment.p1), {}};
  const auto& [p0, p1, part] = result;
  std::optional<LinePart> left = keepPositive({}, p0.depth - nearPlane, p1.depth - nearPlane);
  if (left) left = keepPositive(*left, p0.lateral + edge * p0.depth, p1.lateral + edge * p1.depth);
  if (left) left = keepPositive(*left, edge * p0.depth - p0.lateral, edge * p1.depth - p1.lateral);
  result.part = left;
  return result;
}

bool facesEye(const ViewedSegment& segment) {
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
    const ViewedSegment seen = viewed(projection, segment, edge, kNearPlane);
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
    const ViewedSegment seen = viewed(projection, segment, edge, kNearPlane);
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
    findVisibleSpans(scene, camera, projection, scratch).forEachSpan([&](const Span& span) {
      const SectorId sector = scene[span.surface].sector;
      seenSectors_[sector.index()] = true;
      for (int row = span.rowBegin; row < span.rowEnd; ++row)
        pixels_[index(span.column, row)] = {sector, span.depth};
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
    const ViewedSegment seen = viewed(projection, segment, edge, nearPlane);
    if (seen.part && facesEye(seen)) draw(segment, seen);
  });
}

// --- Depth space -----------------------------------------------------------------------------

void drawDepthSpace(const Scene& scene, const Camera& camera, const Projection& projection,
                    const PixelRows& picture) {
  const ShownPixels shown(scene, camera, projection);
  double nearest = 0;  // the greatest 1/depth, which goes to the lower edge
  forSegmentsInView(scene, camera, projection, shown, kNearPlane,
                    [&](const Segment&, const ViewedSegment& seen) {
                      for (const double fraction : {seen.part->from, seen.part->to})
                        nearest = std::max(nearest, 1 / seen.at(fraction).depth);
                    });

  const double top = kMargin * camera.height;  // where 1/depth is 0
  const double scale = nearest > 0 ? (camera.height - 2 * top) / nearest : 0;
  drawLine(picture, {0, top}, {picture.width + 0.0, top}, kAxis);
  drawLine(picture, {camera.width / 2.0, 0}, {camera.width / 2.0, picture.height + 0.0}, kAxis);
  forSegmentsInView(scene, camera, projection, shown, kNearPlane,
                    [&](const Segment& segment, const ViewedSegment& seen) {
                      const auto toPicture = [&](double fraction) {
                        const CameraPoint p = seen.at(fraction);
                        return Vec2{projection.columnOf(p), top + scale / p.depth};
                      };
                      drawLine(picture, toPicture(seen.part->from), toPicture(seen.part->to),
                               colorOf(scene, segment));
                    });
}

// --- Screen ----------------------------------------------------------------------------------

/// Where a line begins or ends: at a fraction of the way along a segment, at a height.
struct LineEnd {
  double fraction;
  double z;
};

/// Calls `draw(from, to, color)` for the edges of the part of a segment in the field of view.
template <typename Draw>
class SegmentEdges {
 public:
  SegmentEdges(const Scene& scene, const Segment& segment, LinePart part, const Draw& draw)
      : scene_(scene), segment_(segment), part_(part), draw_(draw) {}

  void visit() const {
    const Sector& sector = scene_[segment_.sector];
    along(colorOf(sector.floor), 1,
          [&](double fraction) { return scene_.airAt(segment_, fraction).zBottom; });
    along(colorOf(sector.ceiling), 1,
          [&](double fraction) { return scene_.airAt(segment_, fraction).zTop; });
    if (part_.from == 0) upright(0);
    if (part_.to == 1) upright(1);
    const std::span<const WallPiece> pieces = scene_.piecesOf(segment_);
    for (std::size_t i = 1; i < pieces.size(); ++i) borderBelow(pieces[i]);
    for (const WallPiece& piece : pieces)
      if (const Opening* opening = std::get_if<Opening>(&piece.content)) frame(piece, *opening);
  }

 private:
  /// Between two parts of a stack; frames of openings come over it. Slopes may bend it.
  void borderBelow(const WallPiece& piece) const {
    along(kFlatPortalColor, scene_.geometryOf(segment_).airRises ? kBentPieces : 1,
          [&](double fraction) {
            const AirColumn air = scene_.airAt(segment_, fraction);
            return std::clamp(piece.zBottom, air.zBottom, air.zTop);
          });
  }

  /// The lower and upper edge of an opening. They may bend where two slopes cross.
  void frame(const WallPiece& piece, const Opening& opening) const {
    const Segment& twin = scene_[opening.twin];
    const auto span = [&](double fraction) {
      return openingSpan(piece, scene_.airAt(segment_, fraction), scene_.airAt(twin, 1 - fraction));
    };
    const bool isBent = scene_.geometryOf(segment_).airRises || scene_.geometryOf(twin).airRises;
    const int pieces = isBent ? kBentPieces : 1;
    along(kWayOnColor, pieces, [&](double fraction) { return span(fraction).zBottom; });
    along(kWayOnColor, pieces, [&](double fraction) { return span(fraction).zTop; });
  }

  void upright(double fraction) const {
    const AirColumn air = scene_.airAt(segment_, fraction);
    draw_(LineEnd{fraction, air.zBottom}, LineEnd{fraction, air.zTop}, colorOf(scene_, segment_));
  }

  template <typename Height>
  void along(Rgb color, int pieces, Height&& height) const {
    for (int i = 0; i < pieces; ++i) {
      const double a = std::lerp(part_.from, part_.to, static_cast<double>(i) / pieces);
      const double b = std::lerp(part_.from, part_.to, (i + 1.0) / pieces);
      draw_(LineEnd{a, height(a)}, LineEnd{b, height(b)}, color);
    }
  }

  static constexpr int kBentPieces = 16;

  Scene scene_;
  const Segment& segment_;
  LinePart part_;
  const Draw& draw_;
};

/// Calls `plot(x, y, depth, color)` for the pixels of a segment's edges, whatever hides them.
template <typename Plot>
void plotEdges(const Scene& scene, const Projection& projection, const Camera& camera,
               const Segment& segment, const ViewedSegment& seen, Plot&& plot) {
  const auto draw = [&](LineEnd from, LineEnd to, Rgb color) {
    const CameraPoint a = seen.at(from.fraction);
    const CameraPoint b = seen.at(to.fraction);
    const Vec2 onScreenA{projection.columnOf(a), projection.rowOf(from.z, a.depth)};
    const Vec2 onScreenB{projection.columnOf(b), projection.rowOf(to.z, b.depth)};
    forEachPixelOfLine(onScreenA, onScreenB, camera.width, camera.height,
                       [&](int x, int y, double fraction) {
                         plot(x, y, 1 / std::lerp(1 / a.depth, 1 / b.depth, fraction), color);
                       });
  };
  SegmentEdges(scene, segment, *seen.part, draw).visit();
}

/// Dim where something hides an edge.
void drawScreen(const Scene& scene, const Camera& camera, const Projection& projection,
                const PixelRows& picture) {
  const ShownPixels shown(scene, camera, projection);
  const auto draw = [&](const Segment& segment, const ViewedSegment& seen) {
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

// --- Wireframe -----------------------------------------------------------------------------------

/// Metres at which lines are half as bright as beside the eye.
constexpr double kHalfBright = 20;
constexpr double kLeastBright = 0.25;

Rgb faded(Rgb color, double depth) {
  const double fraction = std::max(kLeastBright, kHalfBright / (kHalfBright + depth));
  const auto fade = [fraction](std::uint8_t c) { return static_cast<std::uint8_t>(fraction * c); };
  return {fade(color.r), fade(color.g), fade(color.b)};
}

void drawWireframe(const Scene& scene, const Camera& camera, const Projection& projection,
                   const PixelRows& picture) {
  const double edge = slantOfEdge(camera, projection);
  forWallsThenWaysOn(scene, [&](const Segment& segment) {
    const ViewedSegment seen = viewed(projection, segment, edge, kNearPlaneOfScreen);
    if (!seen.part) return;
    plotEdges(scene, projection, camera, segment, seen, [&](int x, int y, double depth, Rgb color) {
      *picture.at(x, y) = toXrgb(faded(color, depth));
    });
  });
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
