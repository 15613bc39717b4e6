#include "viewer/overlay/automap.h"

#include <algorithm>
#include <set>
#include <span>
#include <string_view>
#include <variant>

#include "math/trig.h"
#include "render/line.h"
#include "viewer/overlay/captions.h"

namespace hearth {

namespace {

constexpr double kZoomStep = 1.25;
constexpr double kFewestMetres = 2;
constexpr double kMaxMetres = 4096;

/// How far below the eye the player's own storey reaches, in metres.
constexpr double kBodyBelowEye = 1.6;

class AutomapDrawer {
 public:
  AutomapDrawer(const PixelRows& picture, const Scene& scene, const SeenSectors& seen,
                const Eye& eye, double metres)
      : picture_(picture),
        scene_(scene),
        seen_(seen),
        eye_(eye),
        lineWidth_(captionScale(picture)),
        scale_(mapScale(picture.width, picture.height, eye, metres)) {}

  void draw() {
    darken(picture_, 0, 0, picture_.width, picture_.height);
    // Other storeys first, and walls last: they stay visible where they share a line.
    for (const bool isOwnStorey : {false, true}) {
      for (const WallKind kind : {WallKind::Opening, WallKind::Step, WallKind::Solid})
        drawWalls(kind, isOwnStorey);
      drawFlatPortals(isOwnStorey);
    }
    drawPlayer();
  }

 private:
  template <typename Draw>
  void forSeenSegments(bool isOwnStorey, Draw&& draw) const {
    for (const Sector& sector : scene_.level().sectors) {
      if (!seen_.has(sector.id) || isOnOwnStorey(sector) != isOwnStorey) continue;
      for (const Segment& segment : scene_.segmentsOf(sector)) draw(sector, segment);
    }
  }

  bool isOnOwnStorey(const Sector& sector) const {
    return scene_.zFloor(sector) <= eye_.point.z &&
           scene_.zCeiling(sector) >= eye_.point.z - kBodyBelowEye;
  }

  void drawWalls(WallKind kind, bool isOwnStorey) {
    const Rgb color = colorOf(kind);
    forSeenSegments(isOwnStorey, [&](const Sector&, const Segment& segment) {
      if (wallKind(scene_, segment) == kind)
        drawLine(segment.p0, segment.p1, isOwnStorey ? color : dimmed(color));
    });
  }

  void drawFlatPortals(bool isOwnStorey) {
    const Rgb color = isOwnStorey ? kMapFlatPortalColor : dimmed(kMapFlatPortalColor);
    forSeenSegments(isOwnStorey, [&](const Sector& sector, const Segment& segment) {
      if (sector.floor.flatPortal || sector.ceiling.flatPortal)
        drawLine(segment.p0, segment.p1, color, 2);
    });
  }

  /// An arrow, its middle where the player is.
  void drawPlayer() {
    constexpr double kLength = 12;  // pixels of letters
    constexpr double kHalfWidth = 4;
    const auto [sin, cos] = sinCosDegrees(eye_.angle);
    const double metre = lineWidth_ / scale_.pixelsPerMetre;  // that a pixel of letters is
    const Vec2 ahead = metre * Vec2{cos, sin};
    const Vec2 right = turned90(ahead);
    const Vec2 tip = eye_.point.xy() + kLength / 2 * ahead;
    const Vec2 tail = tip - kLength * ahead;
    drawLine(tip, tail + kHalfWidth * right, kPlayerColor);
    drawLine(tip, tail - kHalfWidth * right, kPlayerColor);
    drawLine(tail + kHalfWidth * right, tail - kHalfWidth * right, kPlayerColor);
  }

  /// From a to b on the level's map; `gap` > 1 leaves out dots of the line.
  void drawLine(Vec2 a, Vec2 b, Rgb color, int gap = 1) {
    forEachPixelOfLine(scale_.toPicture(a), scale_.toPicture(b), picture_.width, picture_.height,
                       [&](int x, int y, double) {
                         const int dot = (x + y) / (2 * lineWidth_);
                         if (dot % gap == 0) drawDot(x, y, color);
                       });
  }

  void drawDot(int left, int top, Rgb color) {
    for (int y = top; y < std::min(top + lineWidth_, picture_.height); ++y)
      for (int x = left; x < std::min(left + lineWidth_, picture_.width); ++x)
        *picture_.at(x, y) = toXrgb(color);
  }

  static Rgb colorOf(WallKind kind) {
    switch (kind) {
      case WallKind::Solid:
        return kSolidColor;
      case WallKind::Step:
        return kStepColor;
      case WallKind::Opening:
        return kOpeningColor;
    }
    return {};
  }

  static Rgb dimmed(Rgb color) {
    const auto dim = [](std::uint8_t level) { return static_cast<std::uint8_t>(level / 3); };
    return {dim(color.r), dim(color.g), dim(color.b)};
  }

  PixelRows picture_;
  Scene scene_;
  const SeenSectors& seen_;
  const Eye& eye_;
  int lineWidth_;  ///< pixels
  MapScale scale_;
};

}  // namespace

SeenSectors::SeenSectors(const Level& level, const SeenSectors& before) : SeenSectors(level) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < before.isSeen_.size(); ++i)
    if (before.isSeen_[i]) names.insert(before.level_->sectors[i].name);
  for (std::size_t i = 0; i < isSeen_.size(); ++i)
    isSeen_[i] = names.contains(level.sectors[i].name);
}

void SeenSectors::add(const Span& span) { add((*level_)[span.surface].sector); }

WallKind wallKind(const Scene& scene, const Segment& segment) {
  const auto isOpen = [](const WallPiece& piece) {
    return std::holds_alternative<Opening>(piece.content);
  };
  const std::span<const WallPiece> pieces = scene.piecesOf(segment);
  if (std::ranges::none_of(pieces, isOpen)) return WallKind::Solid;
  return std::ranges::all_of(pieces, isOpen) ? WallKind::Opening : WallKind::Step;
}

double zoomedIn(double metres) { return std::max(kFewestMetres, metres / kZoomStep); }
double zoomedOut(double metres) { return std::min(kMaxMetres, metres * kZoomStep); }

MapScale mapScale(int width, int height, const Eye& eye, double metres) {
  return {{width / 2.0, height / 2.0}, eye.point.xy(), std::min(width, height) / metres};
}

void drawAutomap(const PixelRows& picture, const Scene& scene, const SeenSectors& seen,
                 const Eye& eye, double metres) {
  AutomapDrawer(picture, scene, seen, eye, metres).draw();
}

}  // namespace hearth
