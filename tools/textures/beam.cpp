#include <algorithm>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kBeam = 64;

constexpr Ramp kOldOak{
    {{76, 54, 44}, {112, 82, 62}, {144, 110, 84}, {174, 139, 108}, {204, 170, 136}}};

/// A split that time has opened along the grain: dark, with a light lip below.
int splitTone(int x, int across, int beam) {
  const int line = 20 + 24 * beam + smoothNoise(x, beam, {kTileSide, 2, 32, 1}, 94) / 20;
  const int reach = smoothNoise(x, beam, {kTileSide, 2, 64, 1}, 95);
  if (reach < 10) return 0;
  if (across == line) return -60;
  return across == line + 1 ? 22 : 0;
}

// Hewn with an axe: shallow facets along the beam, its edges chamfered.
Rgb pixelAt(int x, int y) {
  const int shifted = wrap(y + kBeam / 2, kTileSide);
  const int beam = shifted / kBeam;
  const int across = shifted % kBeam;
  const int edge = std::min(across, kBeam - 1 - across);
  const int drift = smoothNoise(x, beam, {kTileSide, 2, 32, 1}, 91) / 24;
  const int grain = smoothNoise(x, y + drift, {kTileSide, kTileSide, 64, 4}, 92);
  const int facet = cloudNoise(x + 40 * beam, y, {kTileSide, kTileSide, 32, 16}, 93);
  int tone = 128 + 12 * beam + grain / 4 + facet / 5 + splitTone(x, across, beam);
  if (edge < 6) tone += across < kBeam / 2 ? 34 - 3 * edge : -46 + 4 * edge;
  if (edge == 0) tone -= 40;
  return shade(kOldOak, tone, x, y);
}

}  // namespace

Image makeBeam() { return paintTile(pixelAt); }

}  // namespace hearth::textures
