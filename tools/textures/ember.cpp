#include "textures/cells.h"
#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr Ramp kGlow{
    {{92, 46, 40}, {168, 72, 44}, {226, 118, 56}, {248, 176, 88}, {255, 228, 152}}};

// Coals under a crust of ash: they glow where they part.
Rgb pixelAt(int x, int y) {
  const Cell coal = nearestCell(x, y, 16, 13, 201);
  const int heat = cloudNoise(x, y, {kTileSide, kTileSide, 32, 32}, 204);
  const int ash = smoothNoise(x, y, {kTileSide, kTileSide, 4, 4}, 207);
  const int fromGap = coal.border < 4 ? 26 * (4 - coal.border) : 0;
  return shade(kGlow, 76 + coal.id % 50 + fromGap + heat / 2 + ash / 6, x, y);
}

}  // namespace

// The edges of the image lie where few coals part.
Image makeEmber() {
  return paintTile(
      [](int x, int y) { return pixelAt(wrap(x + 40, kTileSide), wrap(y + 37, kTileSide)); });
}

}  // namespace hearth::textures
