#include <algorithm>
#include <array>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kWidth = 1536;
constexpr int kHeight = 256;

// Dusk, from the zenith down to the haze.
constexpr Ramp kAir{
    {{58, 66, 118}, {92, 92, 146}, {148, 120, 158}, {214, 156, 146}, {244, 204, 164}}};
constexpr Rgb kHaze = kAir.back();
constexpr Rgb kCloudLit{250, 196, 160};
constexpr Rgb kCloud{178, 132, 158};
constexpr Rgb kFarRange{156, 124, 156};
constexpr Rgb kNearRange{92, 82, 124};
constexpr Rgb kMoon{250, 244, 220};
constexpr Rgb kMoonShade{222, 212, 200};

Rgb air(int x, int y) {
  const int tone = y * y / 440 + 3 * y / 8;
  return shade(kAir, std::min(tone, 255), x, y);
}

/// Stars of three sizes of light, above the clouds; none in the rows that repeat beyond the image.
bool star(int x, int y) { return y > 4 && y < 124 && pick(x, y, 61, 62400) < 124 - y; }

bool inDisc(int x, int y, int centreX, int centreY) {
  const int dx = x - centreX;
  const int dy = y - centreY;
  return dx * dx + dy * dy <= 20 * 20;
}

/// The upper rim of a range of mountains: ridges of straight slopes, smaller ones upon larger.
int ridge(int x, int cell, int height, std::uint32_t seed) {
  int rim64 = 0;  // in 1/64 pixel, so that the ridges' roundings do not add up to a step
  for (int octave = 0; octave < 3; ++octave, cell /= 2, height /= 2) {
    const int column = x / cell;
    const int next = (column + 1) % (kWidth / cell);
    const int step = x % cell;
    const int from = pick(column, octave, seed, height);
    const int to = pick(next, octave, seed, height);
    rim64 += 64 * (from * (cell - step) + to * step) / cell;
  }
  return rim64 / 64;
}

Rgb pixelAt(int x, int y) {
  Rgb colour = air(x, y);
  if (star(x, y)) colour = blend(colour, kMoon, 120 + pick(x, y, 62, 136));
  if (inDisc(x, y, 1056, 80)) colour = inDisc(x, y, 1051, 77) ? kMoon : kMoonShade;

  // Clouds: long streaks, lit from below by what is left of the sun.
  const auto cover = [](int i, int j) {
    const int streaks = cloudNoise(i, j, {kWidth, kHeight, 192, 16}, 63);
    const int banks = cloudNoise(i, j, {kWidth, kHeight, 384, 64}, 66) / 2;
    const int wisps = smoothNoise(i, j, {kWidth, kHeight, 24, 2}, 69) / 12;
    return streaks + banks + wisps - std::abs(j - 132) / 2 - 8;
  };
  if (y > 16 && cover(x, y) > 0) {
    const bool rim = cover(x, y + 3) <= 0;
    colour = blend(colour, rim ? kCloudLit : kCloud, cover(x, y) > 18 ? 190 : 110);
  }

  const int up = kHeight - 1 - y;  // rows above the haze
  if (up < 8 + ridge(x, 192, 30, 70)) colour = kFarRange;
  if (up < 4 + ridge(x, 96, 20, 73)) colour = kNearRange;
  return blend(kHaze, colour, std::min(256, up * 60));
}

}  // namespace

Image makeSky() {
  Image image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) image.at(x, y) = pixelAt(x, y);
  }
  return image;
}

}  // namespace hearth::textures
