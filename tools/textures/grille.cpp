#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kUprights = 32;   // pixels from one to the next
constexpr int kCrossbars = 64;  // likewise
constexpr int kUprightHalf = 4;
constexpr int kCrossbarHalf = 5;

constexpr Ramp kBlackIron{
    {{58, 60, 68}, {92, 96, 104}, {126, 130, 136}, {160, 162, 166}, {206, 206, 204}}};

/// Pixels from the middle of the nearest of bars that repeat: to the left negative.
int fromMiddle(int along, int pitch) { return wrap(along, pitch) - pitch / 2; }

bool isBar(int x, int y) {
  return std::abs(fromMiddle(x, kUprights)) < kUprightHalf ||
         std::abs(fromMiddle(y, kCrossbars)) < kCrossbarHalf;
}

/// Round uprights before flat crossbars, riveted where they meet, lit from the upper left. Holes
/// have the iron's colour, so that pixels mixed with them keep it.
Rgb pixelAt(int x, int y) {
  const int dx = fromMiddle(x, kUprights);
  const int dy = fromMiddle(y, kCrossbars);
  int tone = 128 + cloudNoise(x, y, {kTileSide, kTileSide, 16, 16}, 141) / 4;
  if (std::abs(dx) < kUprightHalf && std::abs(dy) >= kCrossbarHalf) tone -= 26 * dx;
  if (std::abs(dy) < kCrossbarHalf) tone += dy < -2 ? 50 : dy > 2 ? -60 : 0;
  if (dx * dx + dy * dy <= 10) tone += 30 - 16 * (dx + dy);
  return shade(kBlackIron, tone, x, y);
}

}  // namespace

Image makeGrille() {
  Image grille = paintTile(pixelAt);
  for (int y = 0; y < kTileSide; ++y)
    for (int x = 0; x < kTileSide; ++x)
      if (!isBar(x, y)) grille.makeHole(x, y);
  return grille;
}

}  // namespace hearth::textures
