#include <array>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kTile = 16;  // width and visible length of a tile, in pixels

constexpr Ramp kTerracotta{
    {{92, 48, 44}, {138, 74, 58}, {176, 102, 72}, {204, 134, 94}, {230, 170, 126}}};
constexpr Ramp kSmoked{
    {{88, 52, 48}, {130, 76, 64}, {166, 104, 82}, {194, 134, 106}, {220, 168, 138}}};
constexpr Ramp kMossy{
    {{89, 53, 45}, {134, 82, 60}, {171, 111, 76}, {198, 141, 98}, {223, 174, 129}}};

/// How far a tile's round lower edge is cut away above its lowest row, by column.
constexpr std::array<int, kTile> kCut{7, 5, 3, 2, 1, 1, 0, 0, 0, 0, 1, 1, 2, 3, 5, 7};

struct TilePixel {
  int column;  ///< within the tile
  int below;   ///< rows below the tile's upper visible row
  int tile;    ///< along the course
  int course;
};

/// The tile that is on top at the pixel: that of its own course, or, where the round edge is cut
/// away, of the next one, which lies below it and half a tile aside.
TilePixel tileAt(int x, int y) {
  const auto inCourse = [x](int course, int below) {
    const int along = wrap(x + kTile / 4 + (course % 2) * kTile / 2, kTileSide);
    return TilePixel{along % kTile, below, along / kTile, course};
  };
  const int course = wrap(y + kTile / 2, kTileSide) / kTile;
  const int below = wrap(y + kTile / 2, kTile);
  const TilePixel upper = inCourse(course, below);
  const bool cutAway = below >= kTile - kCut[static_cast<std::size_t>(upper.column)];
  return cutAway ? inCourse((course + 1) % 8, below - kTile) : upper;
}

const Ramp& rampOf(TilePixel pixel) {
  static constexpr std::array<const Ramp*, 6> kMix{&kTerracotta, &kTerracotta, &kTerracotta,
                                                   &kSmoked,     &kSmoked,     &kMossy};
  return *kMix[static_cast<std::size_t>(pick(pixel.tile, pixel.course, 51, 6))];
}

Rgb pixelAt(int x, int y) {
  const TilePixel pixel = tileAt(x, y);
  const int edge = kTile - 1 - kCut[static_cast<std::size_t>(pixel.column)] - pixel.below;
  const int clouds = cloudNoise(x, y, {kTileSide, kTileSide, 8, 8}, 52);
  int tone = 116 + pick(pixel.tile, pixel.course, 53, 44) - 22 + clouds / 7 + 3 * pixel.below;
  if (edge == 0) tone -= 70;  // the edge's own thickness
  if (edge == 1) tone += 34;  // light caught by its rim
  if (pixel.below < 0 && pixel.below > -5) tone -= 4 * (8 + pixel.below);  // gap between two tiles
  if (pixel.column == 0 && pixel.below >= 0) tone -= 56;
  if (pixel.column == 1 && pixel.below >= 0) tone += 16;
  return shade(rampOf(pixel), tone, x, y);
}

}  // namespace

Image makeRoof() { return paintTile(pixelAt); }

}  // namespace hearth::textures
