#include <algorithm>
#include <array>

#include "textures/cells.h"
#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr Ramp kGrey{
    {{84, 80, 80}, {116, 110, 106}, {146, 139, 131}, {172, 165, 155}, {202, 195, 182}}};
constexpr Ramp kBrown{
    {{88, 78, 71}, {122, 109, 97}, {153, 138, 122}, {180, 164, 146}, {208, 193, 174}}};
constexpr Ramp kBlue{
    {{81, 80, 83}, {111, 109, 110}, {140, 138, 136}, {168, 164, 159}, {198, 194, 186}}};
constexpr Ramp kSoil{
    {{84, 66, 52}, {114, 92, 71}, {142, 118, 92}, {166, 142, 114}, {190, 168, 138}}};
constexpr Ramp kTurf{
    {{66, 76, 54}, {92, 104, 66}, {118, 130, 80}, {144, 154, 98}, {174, 180, 124}}};
constexpr Ramp kStraw{
    {{112, 88, 48}, {148, 120, 66}, {182, 152, 88}, {208, 180, 114}, {230, 208, 150}}};

/// Light from the upper left on a round top.
int domeTone(const Cell& cell, int strength) { return -strength * (cell.dx + cell.dy) / 16; }

// The image's edges run through the middles of stones.
Rgb cobblePixel(int x, int y) {
  static constexpr std::array<const Ramp*, 5> kMix{&kGrey, &kBrown, &kGrey, &kBlue, &kBrown};
  const Cell cell = nearestCell(wrap(x + 8, kTileSide), wrap(y + 8, kTileSide), 16, 11, 101);
  const int rough = smoothNoise(x, y, {kTileSide, kTileSide, 4, 4}, 104);
  if (cell.border < 1) return shade(kSoil, 66 + rough / 4, x, y);
  const int rim = cell.border < 3 ? 26 - 10 * (cell.border - 1) : 0;
  const int tone = 136 + cell.id % 44 - 22 + domeTone(cell, 44) + rough / 9 - rim;
  return shade(*kMix[static_cast<std::size_t>(cell.id / 64 % 5)], tone, x, y);
}

Rgb dirtPixel(int x, int y) {
  const int clouds = cloudNoise(x, y, {kTileSide, kTileSide, 32, 32}, 105);
  const int grit = smoothNoise(x, y, {kTileSide, kTileSide, 4, 2}, 108);
  const Cell pebble = nearestCell(x, y, 16, 14, 109);
  const int size = 1 + pebble.id % 3;
  const int reach = pebble.dx * pebble.dx + 2 * pebble.dy * pebble.dy;
  const bool isThere = pebble.id / 8 % 3 == 0;
  if (isThere && reach <= size * size) {
    return shade(kBrown, 140 + domeTone(pebble, 120) + pebble.id / 32 % 30, x, y);
  }
  const bool shadowed = isThere && reach <= (size + 2) * (size + 2) && pebble.dx + pebble.dy > 0;
  return shade(kSoil, 140 + clouds / 6 + grit / 7 - (shadowed ? 40 : 0), x, y);
}

/// Tufts: blades that lean from the middle of each, light at their tips.
Rgb grassPixel(int x, int y) {
  const int clouds = cloudNoise(x, y, {kTileSide, kTileSide, 64, 64}, 112);
  const Cell tuft = nearestCell(wrap(x + 5, kTileSide), wrap(y + 3, kTileSide), 8, 8, 115);
  const int lean = tuft.id % 3 - 1;
  const int blades = smoothNoise(x + lean * y, y, {kTileSide, kTileSide, 2, 8}, 118);
  const int tone =
      134 + clouds / 7 + blades / 8 - 4 * std::clamp(tuft.dy, -4, 6) + tuft.id / 4 % 24 - 12;
  return shade(kTurf, tone, x, y);
}

/// Handfuls of stalks, each fallen its own way, upon one another.
Rgb hayPixel(int x, int y) {
  const int clouds = cloudNoise(x, y, {kTileSide, kTileSide, 64, 64}, 121);
  const Cell handful = nearestCell(x, y, 16, 16, 124);
  const int lean = handful.id % 5 - 2;
  const Grain stalks{kTileSide, kTileSide, 16, 2};
  const int stalk = handful.id / 8 % 3 == 0 ? smoothNoise(y, x + lean * y, stalks, 127)
                                            : smoothNoise(x, y + lean * x, stalks, 128);
  const int rim = handful.border < 2 ? 24 : 0;
  return shade(kStraw, 136 + stalk / 3 + clouds / 8 + handful.id / 32 % 30 - 15 - rim, x, y);
}

}  // namespace

Image makeCobble() { return paintTile(cobblePixel); }

Image makeDirt() { return paintTile(dirtPixel); }

Image makeGrass() { return paintTile(grassPixel); }

Image makeHay() { return paintTile(hayPixel); }

}  // namespace hearth::textures
