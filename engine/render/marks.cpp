#include "render/marks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "render/outlines.h"
#include "render/renderer.h"

namespace hearth {

namespace {

/// What lies to the left of a pixel and above it, if anything of the picture does.
struct Neighbours {
  const ShownPixel* left;
  const ShownPixel* above;
};

Neighbours neighboursOf(const ShownStrip& shown, int column, int row) {
  return {column > 0 ? &shown.at(column - 1, row) : nullptr,
          row > 0 ? &shown.at(column, row - 1) : nullptr};
}

Rgb mixed(Rgb a, Rgb b, double shareOfB) {
  const auto channel = [shareOfB](double from, double to) {
    return static_cast<std::uint8_t>(std::lround(std::lerp(from, to, shareOfB)));
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

/// The way on the texel grid from a neighbouring pixel, if that shows the same surface.
std::optional<Vec2> stepFrom(const ShownPixel* neighbour, const ShownPixel& pixel) {
  if (!neighbour || neighbour->surface != pixel.surface || !neighbour->texel) return std::nullopt;
  return *pixel.texel - *neighbour->texel;
}

std::int64_t lineBefore(double texel) { return static_cast<std::int64_t>(std::floor(texel)); }

/// How strongly a pixel shows a line across one axis of the grid, given its place there and how far
/// it is from its neighbours'.
double strengthOfLine(double texel, double fromLeft, double fromAbove) {
  const std::int64_t line = lineBefore(texel);
  const std::int64_t left = lineBefore(texel - fromLeft);
  const std::int64_t above = lineBefore(texel - fromAbove);
  if (line == left && line == above) return 0;
  const double texelsPerPixel = std::sqrt(fromLeft * fromLeft + fromAbove * fromAbove);
  double strength = 0;
  for (const auto& [everyLog2, full] : kLines) {
    const std::int64_t its = line >> everyLog2;
    if (its != left >> everyLog2 || its != above >> everyLog2)
      strength = std::max(strength, full * visibility((1 << everyLog2) / texelsPerPixel));
  }
  return strength;
}

Rgb withTexels(const ShownPixel& pixel, const Neighbours& neighbours, Rgb lit) {
  if (!pixel.texel) return lit;
  const Vec2 fromLeft = stepFrom(neighbours.left, pixel).value_or(Vec2{});
  const Vec2 fromAbove = stepFrom(neighbours.above, pixel).value_or(Vec2{});
  const double strength = std::max(strengthOfLine(pixel.texel->x, fromLeft.x, fromAbove.x),
                                   strengthOfLine(pixel.texel->y, fromLeft.y, fromAbove.y));
  return strength > 0 ? mixed(lit, kTexelColor, strength) : lit;
}

// --- Coverage ------------------------------------------------------------------------------------

constexpr Rgb kTwice = {255, 0, 0};
constexpr double kShareLeft = 0.35;  // of the picture, so that no wall looks like a signal

Rgb signalOf(const ShownPixel& pixel, Rgb lit) {
  if (pixel.times == 0) return kHole;
  return pixel.times == 1 ? mixed({}, lit, kShareLeft) : kTwice;
}

Rgb marked(Marks marks, const Level& level, const ShownPixel& pixel, const Neighbours& neighbours,
           Rgb lit) {
  switch (marks) {
    case Marks::Texels:
      return withTexels(pixel, neighbours, lit);
    case Marks::Outlines:
      return outlineColor(level, pixel, neighbours.left, neighbours.above).value_or(lit);
    case Marks::Coverage:
      return signalOf(pixel, lit);
  }
  return lit;
}

}  // namespace

void mark(Marks marks, const Level& level, const ShownStrip& shown, int columnEnd, Strip& strip) {
  for (int column = shown.firstColumn(); column < columnEnd; ++column)
    for (int row = 0; row < shown.height(); ++row) {
      Pixel& pixel = *strip.at(column, row);
      pixel = pixelOf(marked(marks, level, shown.at(column, row), neighboursOf(shown, column, row),
                             colorOf(pixel)));
    }
}

}  // namespace hearth
