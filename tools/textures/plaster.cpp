#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kCell = 16;  // one trowel mark starts in every cell of so many pixels
constexpr int kQuietRow = 103;
constexpr Grain kBroad{kTileSide, kTileSide, 32, 32};

constexpr Ramp kLime{
    {{128, 112, 96}, {156, 140, 120}, {182, 167, 144}, {202, 189, 166}, {220, 210, 189}}};

/// The tone that the trowel mark of one cell adds: a shallow arc, dark below and light above,
/// which fades towards its ends.
int markTone(int x, int y, int cellX, int cellY) {
  const int dx = x - cellX * kCell - pick(cellX & 7, cellY & 7, 41, kCell);
  const int dy = y - cellY * kCell - pick(cellX & 7, cellY & 7, 42, kCell);
  const int halfLength = 7 + pick(cellX & 7, cellY & 7, 43, 8);
  if (std::abs(dx) >= halfLength) return 0;
  const int slope = pick(cellX & 7, cellY & 7, 44, 9) - 4;
  const int below = dy - (8 * slope * dx + dx * dx) / 64;
  const int strength = 22 * (halfLength - std::abs(dx)) / halfLength;
  if (below == 0) return -strength;
  return below == -1 ? strength : 0;
}

int marksTone(int x, int y) {
  int tone = 0;
  for (int cellY = y / kCell - 1; cellY <= y / kCell + 1; ++cellY) {
    for (int cellX = x / kCell - 2; cellX <= x / kCell + 1; ++cellX) {
      tone += markTone(x, y, cellX, cellY);
    }
  }
  return tone;
}

/// Hairline cracks follow the zero line of a coarse noise, where another noise lets them: in few
/// places and for a short way, because what closes to a figure is known again in every repeat.
bool cracked(int x, int y) {
  const auto high = [](int i, int j) { return cloudNoise(i, j, kBroad, 45) > 0; };
  const bool line = high(x, y) != high(x + 1, y) || high(x, y) != high(x, y + 1);
  return line && smoothNoise(x, y, kBroad, 53) > 92;
}

Rgb pixelAt(int x, int y) {
  const int patches = cloudNoise(x, y, {kTileSide, kTileSide, 64, 64}, 47);
  const int sand = smoothNoise(x, y, {kTileSide, kTileSide, 2, 2}, 48);
  int tone = 140 + patches / 9 + sand / 12 + marksTone(x, y);
  if (cracked(x, y)) {
    tone -= 26;
  } else if (cracked(x - 1, y - 1)) {
    tone += 9;  // the crack's far lip
  }
  return shade(kLime, tone, x, y);
}

}  // namespace

// The edge of the image lies where few marks cross it.
Image makePlaster() {
  return paintTile([](int x, int y) { return pixelAt(x, wrap(y + kQuietRow, kTileSide)); });
}

}  // namespace hearth::textures
