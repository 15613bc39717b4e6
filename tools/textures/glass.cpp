#include <algorithm>
#include <array>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kPane = 32;

constexpr Ramp kAmber{
    {{150, 100, 60}, {188, 136, 82}, {216, 168, 108}, {234, 196, 140}, {246, 220, 178}}};
constexpr Ramp kSea{
    {{72, 104, 118}, {98, 136, 146}, {126, 164, 168}, {158, 190, 188}, {196, 216, 208}}};
constexpr Ramp kRose{
    {{140, 76, 76}, {178, 104, 96}, {206, 134, 120}, {224, 166, 150}, {238, 198, 182}}};
constexpr Ramp kPearl{
    {{136, 132, 134}, {164, 160, 156}, {190, 185, 176}, {210, 205, 194}, {228, 224, 214}}};
constexpr Ramp kLead{{{48, 48, 58}, {64, 64, 74}, {82, 82, 90}, {106, 106, 112}, {140, 140, 142}}};

// Leaded panes in lozenges, a colour to each, and the sky's light uneven in them. No two that touch
// are alike, nor do those of one colour lie in a row.
Rgb pixelAt(int x, int y) {
  using Row = std::array<const Ramp*, 4>;
  static constexpr std::array<Row, 4> kMix{{{&kAmber, &kPearl, &kSea, &kRose},
                                            {&kSea, &kAmber, &kPearl, &kSea},
                                            {&kPearl, &kRose, &kAmber, &kPearl},
                                            {&kRose, &kSea, &kPearl, &kAmber}}};
  const int rising = wrap(x + y + kPane / 2, kTileSide);
  const int falling = wrap(x - y + kPane / 2, kTileSide);
  const int lead = std::min(rising % kPane, falling % kPane);
  if (lead < 3) return shade(kLead, lead == 0 ? 170 : 110 - 40 * lead, x, y);
  const int glow = cloudNoise(x, y, {kTileSide, kTileSide, 32, 32}, 181);
  const Ramp& ramp =
      *kMix[static_cast<std::size_t>(rising / kPane)][static_cast<std::size_t>(falling / kPane)];
  return shade(ramp, 150 + glow / 3 - rising % kPane, x, y);
}

}  // namespace

Image makeGlass() { return paintTile(pixelAt); }

}  // namespace hearth::textures
