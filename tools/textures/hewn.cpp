#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr Ramp kPale{
    {{104, 102, 98}, {136, 133, 127}, {166, 162, 153}, {190, 186, 174}, {214, 210, 198}}};

// Hewn from one block: broad clouds, fine pits, and streaks where rain ran down.
Rgb pixelAt(int x, int y) {
  const int clouds = cloudNoise(x, y, {kTileSide, kTileSide, 64, 64}, 221);
  const int pits = smoothNoise(x, y, {kTileSide, kTileSide, 2, 2}, 224);
  const int streaks = smoothNoise(x, y, {kTileSide, kTileSide, 8, 64}, 225);
  const bool isPit = pits > 104 && clouds < 20;
  return shade(kPale, 138 + clouds / 7 + pits / 16 + streaks / 10 - (isPit ? 34 : 0), x, y);
}

}  // namespace

Image makeHewn() { return paintTile(pixelAt); }

}  // namespace hearth::textures
