#include "render/marks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "render/outline_color.h"
#include "render/renderer.h"
#include "render/strip.h"

namespace hearth {

namespace {

Rgb mixed(Rgb a, Rgb b, double fractionOfB) {
  const auto channel = [fractionOfB](double from, double to) {
    return static_cast<std::uint8_t>(std::lround(std::lerp(from, to, fractionOfB)));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

// --- Texels --------------------------------------------------------------------------------------

constexpr Rgb kTexelColor = {64, 224, 255};

/// Every eighth line is stronger, and every eighth of those: they stay where texels are too small
/// for lines of their own.
struct Lines {
  int everyLog2;  ///< of the texels from one to the next
  double strength;
};
constexpr Lines kLines[] = {{0, 0.3}, {3, 0.6}, {6, 0.8}};

// Pixels between lines from which on they begin to show, and show in full.
constexpr double kNarrowest = 3;
constexpr double kWideEnough = 9;

double visibility(double pixelsApart) {
  return std::clamp((pixelsApart - kNarrowest) / (kWideEnough - kNarrowest), 0.0, 1.0);
}

/// Whether a line of the grid lies between a pixel and its neighbour: only within a surface.
bool isLineBetween(const ShownTexel& pixel, const ShownTexel& neighbour) {
  return pixel.surface == neighbour.surface && pixel.lines != neighbour.lines;
}

/// What lies left of or above a pixel on its surface; where that shows another, the pixel itself.
const ShownTexel& onSurfaceOf(const ShownTexel& pixel, const ShownTexel& neighbour) {
  return pixel.surface == neighbour.surface ? neighbour : pixel;
}

/// How strongly a pixel shows a line across one axis of the grid, given the lines before it and its
/// neighbours, and how far they are apart.
double strengthOfLine(std::int64_t line, std::int64_t left, std::int64_t above,
                      double texelsPerPixel) {
  double strength = 0;
  for (const auto& [everyLog2, full] : kLines) {
    const std::int64_t its = line >> everyLog2;
    if (its != left >> everyLog2 || its != above >> everyLog2)
      strength = std::max(strength, full * visibility((1 << everyLog2) / texelsPerPixel));
  }
  return strength;
}

double strengthOfLines(const ShownTexel& pixel, const ShownTexel& left, const ShownTexel& above) {
  const Vec2 fromLeft = pixel.texel - left.texel;
  const Vec2 fromAbove = pixel.texel - above.texel;
  const auto length = [](double a, double b) { return std::sqrt(a * a + b * b); };
  return std::max(
      strengthOfLine(pixel.lines.s, left.lines.s, above.lines.s, length(fromLeft.x, fromAbove.x)),
      strengthOfLine(pixel.lines.t, left.lines.t, above.lines.t, length(fromLeft.y, fromAbove.y)));
}

void markLines(const ShownTexel& shown, const ShownTexel& left, const ShownTexel& above,
               std::uint32_t& pixel) {
  const double strength =
      strengthOfLines(shown, onSurfaceOf(shown, left), onSurfaceOf(shown, above));
  if (strength > 0) pixel = toXrgb(mixed(fromXrgb(pixel), kTexelColor, strength));
}

// --- Coverage ------------------------------------------------------------------------------------

constexpr Rgb kTwice = {255, 0, 0};
constexpr double kFractionLeft = 0.35;  // of the picture, so that no wall looks like a signal

Rgb signalOf(int times, Rgb lit) {
  if (times == 0) return kHole;
  return times == 1 ? mixed({}, lit, kFractionLeft) : kTwice;
}

// --- Vertices ------------------------------------------------------------------------------------

constexpr Rgb kVertexColor = {255, 232, 32};

struct DotPlace {
  int column;
  int row;
};

/// The pixel that a point lies in, if it is in the picture.
std::optional<DotPlace> pixelOf(const Projection& projection, Vec3 point,
                                const PixelRows& picture) {
  const CameraPoint seen = projection.toCamera(point.xy());
  if (!(seen.depth > 0)) return std::nullopt;
  const double column = projection.columnOf(seen);
  const double row = projection.rowOf(point.z, seen.depth);
  if (!(column >= 0 && column < picture.width && row >= 0 && row < picture.height))
    return std::nullopt;
  return DotPlace{static_cast<int>(column), static_cast<int>(row)};
}

void drawDot(DotPlace middle, ColumnRange columns, const PixelRows& picture) {
  const int columnEnd = std::min(middle.column + kDotRadius + 1, columns.end);
  const int rowEnd = std::min(middle.row + kDotRadius + 1, picture.height);
  for (int row = std::max(middle.row - kDotRadius, 0); row < rowEnd; ++row)
    for (int column = std::max(middle.column - kDotRadius, columns.begin); column < columnEnd;
         ++column)
      *picture.at(column, row) = toXrgb(kVertexColor);
}

/// Calls `markPixel(pixel, shown, left, above)` for each pixel, with what it and its neighbours
/// show; beyond the picture nothing shows.
template <typename Shown, typename MarkPixel>
void markEach(const ShownColumns<Shown>& shown, Strip& strip, int column, MarkPixel&& markPixel) {
  const Shown nothing;
  const Shown* above = &nothing;
  for (std::size_t row = 0; row < shown.here().size(); ++row) {
    const Shown& here = shown.here()[row];
    markPixel(*strip.at(column, static_cast<int>(row)), here, shown.left()[row], *above);
    above = &here;
  }
}

}  // namespace

void mark(const Scene&, const ShownColumns<ShownTexel>& shown, Strip& strip, int column) {
  markEach(shown, strip, column,
           [](std::uint32_t& pixel, const ShownTexel& here, const ShownTexel& left,
              const ShownTexel& above) {
             if (here.surface && (isLineBetween(here, left) || isLineBetween(here, above)))
               markLines(here, left, above, pixel);
           });
}

void mark(const Scene& scene, const ShownColumns<ShownSurface>& shown, Strip& strip, int column) {
  markEach(shown, strip, column,
           [&scene](std::uint32_t& pixel, const ShownSurface& here, const ShownSurface& left,
                    const ShownSurface& above) {
             // Most pixels are in the midst of a surface.
             if (here.surface == left.surface && here.surface == above.surface) return;
             if (const auto color = outlineColor(scene, here, left, above)) pixel = toXrgb(*color);
           });
}

void mark(const Scene&, const ShownColumns<ShownTimes>& shown, Strip& strip, int column) {
  markEach(shown, strip, column, [](std::uint32_t& pixel, ShownTimes here, ShownTimes, ShownTimes) {
    pixel = toXrgb(signalOf(here.times, fromXrgb(pixel)));
  });
}

void markVertices(const Projection& projection, std::span<const ShownFace> shown, int column,
                  ColumnRange columns, const PixelRows& picture) {
  const auto height = static_cast<int>(shown.size());
  const auto faceIn = [&](int row) { return shown[static_cast<std::size_t>(row)].face; };
  for (int row = 0; row < height;) {
    const int begin = row;
    const MeshFace* const face = faceIn(begin);
    while (row < height && faceIn(row) == face) ++row;
    if (!face) continue;
    for (const Vec3 corner : face->corners) {
      const std::optional<DotPlace> place = pixelOf(projection, corner, picture);
      if (place && std::abs(place->column - column) <= kDotRadius &&
          place->row >= begin - kDotRadius && place->row < row + kDotRadius)
        drawDot(*place, columns, picture);
    }
  }
}

}  // namespace hearth
