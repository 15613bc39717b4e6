#include <algorithm>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kSlab = 64;

constexpr Ramp kCream{
    {{134, 122, 112}, {164, 152, 138}, {190, 179, 162}, {210, 200, 183}, {228, 220, 206}}};
constexpr Ramp kSlateRose{
    {{84, 72, 76}, {110, 95, 97}, {134, 118, 117}, {156, 140, 136}, {182, 167, 160}}};

/// Veins follow the level lines of a slanted noise: thin where it is steep, blurred where not.
int veinTone(int x, int y, int slab) {
  const int bend =
      cloudNoise(x, y, {kTileSide, kTileSide, 64, 64}, 131 + static_cast<unsigned>(slab));
  const int level = std::abs(wrap(2 * x + 2 * y + bend, 128) - 64);
  if (level < 2) return -42;
  return level < 7 ? -18 : 0;
}

// Slabs of two colours like a chessboard. The image's edges run through their middles.
Rgb pixelAt(int x, int y) {
  const int alongX = wrap(x + kSlab / 2, kTileSide);
  const int alongY = wrap(y + kSlab / 2, kTileSide);
  const int slab = alongX / kSlab + 2 * (alongY / kSlab);
  const bool dark = slab == 1 || slab == 2;
  const BlockPixel pixel{alongX % kSlab, alongY % kSlab, kSlab - 1, kSlab - 1};
  const Ramp& ramp = dark ? kSlateRose : kCream;
  if (edgeDistance(pixel) < 0) return shade(kSlateRose, 20, x, y);
  const int clouds = cloudNoise(x, y, {kTileSide, kTileSide, 32, 32}, 141);
  const int vein = veinTone(dark ? kTileSide - x : x, y, slab);
  return shade(ramp, 140 + clouds / 5 + (dark ? -vein / 3 : vein) + bevel(pixel, 20), x, y);
}

}  // namespace

Image makeMarble() { return paintTile(pixelAt); }

}  // namespace hearth::textures
