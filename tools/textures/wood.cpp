#include <array>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kPlank = 16;
constexpr int kJoint = 1;

constexpr Ramp kOak{{{84, 54, 36}, {128, 86, 54}, {164, 116, 74}, {192, 144, 98}, {218, 176, 128}}};
constexpr Ramp kAmber{
    {{92, 56, 32}, {138, 88, 50}, {174, 120, 70}, {200, 150, 94}, {224, 182, 124}}};
constexpr Ramp kUmber{
    {{78, 52, 40}, {116, 80, 58}, {150, 108, 78}, {178, 136, 100}, {206, 166, 128}}};

const Ramp& rampOf(int plank) {
  static constexpr std::array<const Ramp*, 8> kMix{&kOak,   &kAmber, &kOak,   &kUmber,
                                                   &kAmber, &kOak,   &kUmber, &kOak};
  return *kMix[static_cast<std::size_t>(plank)];
}

/// Where the board of this row ends; boards are as long as the image is wide.
int jointOf(int plank) { return 18 + (plank * 53) % 92; }

/// Distance to the row's knot, in pixels across the grain; knots are drawn out along it.
int knotDistance(int x, int y, int plank) {
  const int dx = wrap(x - jointOf(plank) - 64 - pick(plank, 0, 35, 20) + 10 + 64, kTileSide) - 64;
  const int dy = y - 4 - pick(plank, 1, 35, 6);
  return std::abs(dx) / 3 + std::abs(dy);
}

Rgb pixelAt(int x, int y) {
  const int plank = wrap(y + kPlank / 2, kTileSide) / kPlank;
  const int across = wrap(y + kPlank / 2, kPlank);
  const BlockPixel pixel{wrap(x - jointOf(plank), kTileSide), across, kTileSide - kJoint,
                         kPlank - kJoint};
  const Ramp& ramp = rampOf(plank);
  if (edgeDistance(pixel) < 0) return shade(ramp, 0, x, y);

  // Grain: lines along the plank that drift up and down, and bend around the knot.
  const bool hasKnot = plank % 3 == 1;
  const int knot = hasKnot ? knotDistance(x, across, plank) : kTileSide;
  const int drift = smoothNoise(x + 29 * plank, plank, {kTileSide, 8, 32, 1}, 31) / 16;
  const int bend = knot < 12 ? (12 - knot) / 2 * (across < 8 ? -1 : 1) : 0;
  const int line = smoothNoise(x, 16 * plank + across + drift + bend, {kTileSide, 256, 64, 2}, 32);
  const int fibre = smoothNoise(x, y, {kTileSide, kTileSide, 8, 1}, 33);

  int tone = 142 + pick(plank, 2, 34, 44) - 22 + line / 3 + fibre / 9 + bevel(pixel, 36);
  if (hasKnot && knot < 4) tone -= knot < 2 ? 90 : 50;
  const bool nail = (pixel.x == 4 || pixel.x == pixel.width - 5) && (across == 4 || across == 11);
  if (nail) return shade(ramp, 20, x, y);
  return shade(ramp, tone, x, y);
}

}  // namespace

Image makeWood() { return paintTile(pixelAt); }

}  // namespace hearth::textures
