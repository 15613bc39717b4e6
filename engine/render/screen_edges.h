#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <variant>

#include "level/openings.h"
#include "level/scene.h"
#include "math/line_part.h"
#include "math/tolerance.h"
#include "render/camera.h"
#include "render/line.h"
#include "render/segment_colors.h"

/// The edges of walls as lines on the screen, whether or not anything hides them.
namespace hearth {

/// Metres of depth. What is nearer than any wall is wide is left out.
inline constexpr double kNearPlaneOfScreen = kShortestWall;

/// Walls that lead on come last: they stay visible where they share a line with others.
template <typename Draw>
void forWallsThenWaysOn(const Scene& scene, Draw&& draw) {
  for (const bool areOpen : {false, true})
    for (const Segment& segment : scene.level().segments)
      if (leadsOn(scene, segment) == areOpen) draw(segment);
}

/// Half the width of the field of view at a depth of one metre.
inline double slantOfEdge(const Camera& camera, const Projection& projection) {
  return camera.width / 2.0 / projection.distancePx();
}

/// A line of the map in camera space and the part of it that lies in the field of view.
struct ViewedLine {
  CameraPoint p0;
  CameraPoint p1;
  std::optional<LinePart> part;

  CameraPoint at(double fraction) const {
    return {std::lerp(p0.depth, p1.depth, fraction), std::lerp(p0.lateral, p1.lateral, fraction)};
  }
};

/// `slant` is that of the edge of the field of view (see above), `nearPlane` is in metres of depth.
inline ViewedLine viewed(const Projection& projection, Vec2 p0, Vec2 p1, double slant,
                         double nearPlane) {
  const CameraPoint a = projection.toCamera(p0);
  const CameraPoint b = projection.toCamera(p1);
  std::optional<LinePart> left = keepPositive({}, a.depth - nearPlane, b.depth - nearPlane);
  if (left) left = keepPositive(*left, a.lateral + slant * a.depth, b.lateral + slant * b.depth);
  if (left) left = keepPositive(*left, slant * a.depth - a.lateral, slant * b.depth - b.lateral);
  return {a, b, left};
}

/// Where a line begins or ends: at a fraction of the way along a line of the map, at a height.
struct EdgeEnd {
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
    draw_(EdgeEnd{fraction, air.zBottom}, EdgeEnd{fraction, air.zTop}, colorOf(scene_, segment_));
  }

  template <typename Height>
  void along(Rgb color, int pieces, Height&& height) const {
    for (int i = 0; i < pieces; ++i) {
      const double a = std::lerp(part_.from, part_.to, static_cast<double>(i) / pieces);
      const double b = std::lerp(part_.from, part_.to, (i + 1.0) / pieces);
      draw_(EdgeEnd{a, height(a)}, EdgeEnd{b, height(b)}, color);
    }
  }

  static constexpr int kBentPieces = 16;

  Scene scene_;
  const Segment& segment_;
  LinePart part_;
  const Draw& draw_;
};

/// Calls `plot(x, y, depth)` for the pixels of an edge above a line of the map.
template <typename Plot>
void plotEdge(const Projection& projection, const Camera& camera, const ViewedLine& line,
              EdgeEnd from, EdgeEnd to, Plot&& plot) {
  const CameraPoint a = line.at(from.fraction);
  const CameraPoint b = line.at(to.fraction);
  const Vec2 onScreenA{projection.columnOf(a), projection.rowOf(from.z, a.depth)};
  const Vec2 onScreenB{projection.columnOf(b), projection.rowOf(to.z, b.depth)};
  forEachPixelOfLine(onScreenA, onScreenB, camera.width, camera.height,
                     [&](int x, int y, double fraction) {
                       plot(x, y, 1 / std::lerp(1 / a.depth, 1 / b.depth, fraction));
                     });
}

/// Calls `plot(x, y, depth, color)` for the pixels of a segment's edges, whatever hides them.
template <typename Plot>
void plotEdges(const Scene& scene, const Projection& projection, const Camera& camera,
               const Segment& segment, const ViewedLine& seen, Plot&& plot) {
  const auto draw = [&](EdgeEnd from, EdgeEnd to, Rgb color) {
    plotEdge(projection, camera, seen, from, to,
             [&](int x, int y, double depth) { plot(x, y, depth, color); });
  };
  SegmentEdges(scene, segment, *seen.part, draw).visit();
}

}  // namespace hearth
