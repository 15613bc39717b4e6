#include <algorithm>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kLozenge = 64;

constexpr Ramp kCrimson{
    {{104, 44, 46}, {144, 62, 58}, {178, 84, 74}, {202, 112, 96}, {224, 146, 126}}};
constexpr Ramp kGold{
    {{126, 88, 54}, {164, 122, 74}, {196, 154, 98}, {218, 182, 128}, {236, 208, 162}}};
constexpr Ramp kNight{
    {{58, 56, 82}, {80, 78, 106}, {104, 102, 128}, {130, 127, 148}, {160, 156, 172}}};

// Lozenges with a star in each, woven of threads two pixels thick.
Rgb pixelAt(int x, int y) {
  const int dx = std::abs(x / 2 * 2 % kLozenge - kLozenge / 2);
  const int dy = std::abs(y / 2 * 2 % kLozenge - kLozenge / 2);
  const int lozenge = dx + dy;
  const int weave = (x + y) % 4 < 2 ? 8 : -8;
  const int worn = cloudNoise(x, y, {kTileSide, kTileSide, 32, 32}, 161) / 6;
  const int tone = 128 + weave + worn;
  if (lozenge > 26 && lozenge <= 31) return shade(kGold, tone, x, y);
  if (lozenge > 31) return shade(lozenge > 52 ? kGold : kNight, tone, x, y);
  const bool star = std::min(dx, dy) * 3 + std::max(dx, dy) < 18;
  return shade(star ? kGold : kCrimson, tone + (lozenge > 23 ? -30 : 0), x, y);
}

}  // namespace

Image makeCarpet() { return paintTile(pixelAt); }

}  // namespace hearth::textures
