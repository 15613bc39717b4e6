#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr Ramp kPond{
    {{58, 74, 92}, {80, 102, 118}, {104, 130, 141}, {138, 163, 168}, {186, 202, 198}}};

// Ripples: crests along the level lines of two noises that are drawn out from left to right.
Rgb pixelAt(int x, int y) {
  const int swell = cloudNoise(x, y, {kTileSide, kTileSide, 64, 32}, 151);
  const int bend = cloudNoise(x, y, {kTileSide, kTileSide, 32, 16}, 154);
  const int crest = std::abs(wrap(4 * y + bend, 64) - 32);
  const int cross = smoothNoise(x, y, {kTileSide, kTileSide, 16, 4}, 157);
  int tone = 132 + swell / 4 + cross / 8;
  if (crest < 5 && cross > -20) tone += 34 - 5 * crest;
  if (crest > 24) tone -= 14;
  return shade(kPond, tone, x, y);
}

}  // namespace

Image makeWater() { return paintTile(pixelAt); }

}  // namespace hearth::textures
