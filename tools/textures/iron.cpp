#include <algorithm>
#include <optional>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"
#include "textures/turn.h"

namespace hearth::textures {
namespace {

constexpr int kPlate = 64;
constexpr int kStrap = 13;

constexpr Ramp kIron{
    {{62, 66, 78}, {94, 99, 110}, {128, 132, 140}, {162, 164, 168}, {202, 202, 200}}};
constexpr Ramp kRust{
    {{72, 64, 70}, {106, 94, 96}, {140, 126, 124}, {170, 158, 152}, {204, 194, 186}}};

/// A round head of `radius` pixels at a place, lit from the upper left; 0 elsewhere.
int rivetTone(int dx, int dy, int radius) {
  if (dx * dx + dy * dy > radius * radius + 1) return 0;
  return -18 * (dx + dy) + 24;
}

Rgb metal(int tone, int x, int y) {
  const int rust = cloudNoise(x, y, {kTileSide, kTileSide, 32, 32}, 121);
  const int brushed = smoothNoise(x, y, {kTileSide, kTileSide, 16, 2}, 124);
  return shade(rust > 46 ? kRust : kIron, tone + rust / 10 + brushed / 12, x, y);
}

/// Plates of a door, riveted along their edges. The image's edges run through their middles.
Rgb platePixel(int x, int y) {
  const int row = wrap(y + kPlate / 2, kTileSide) / kPlate;
  const int alongX = wrap(x + kPlate / 4 + row * kPlate / 2, kPlate);
  const BlockPixel pixel{alongX, wrap(y + kPlate / 2, kPlate), kPlate - 1, kPlate - 1};
  if (edgeDistance(pixel) < 0) return shade(kIron, 0, x, y);
  const int fromSideX = std::min(pixel.x, pixel.width - 1 - pixel.x);
  const int fromSideY = std::min(pixel.y, pixel.height - 1 - pixel.y);
  int tone = 130 + bevel(pixel, 50);
  if (fromSideY < 10)
    tone += rivetTone((alongX + 8) % 16 - 8, pixel.y - (pixel.y < 10 ? 5 : 57), 2);
  if (fromSideX < 10 && fromSideY >= 10) {
    tone += rivetTone(alongX - (alongX < 10 ? 5 : 57), (pixel.y + 8) % 16 - 8, 2);
  }
  return metal(tone, x, y);
}

/// A strap across a door at a row, riveted in its middle: its tone, or none beside it.
std::optional<int> strapTone(int x, int y, int row) {
  const int down = y - row;
  if (down < 0 || down >= kStrap) return std::nullopt;
  const int rim = down == 0 ? 40 : down == kStrap - 1 ? -50 : 0;
  return 120 + rim + rivetTone((x + 8) % 32 - 16, down - kStrap / 2, 3);
}

}  // namespace

/// Upright planks behind two straps.
Image makeDoor() {
  Image door = turned(makeWood());
  for (int y = 0; y < kTileSide; ++y) {
    for (int x = 0; x < kTileSide; ++x) {
      for (const int row : {18, 96})
        if (const auto tone = strapTone(x, y, row)) door.at(x, y) = metal(*tone, x, y);
    }
  }
  return door;
}

Image makeIron() { return paintTile(platePixel); }

}  // namespace hearth::textures
