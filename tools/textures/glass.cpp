#include <algorithm>
#include <array>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kPane = 32;
constexpr int kWindowHeight = 288;

constexpr Ramp kAmber{
    {{150, 100, 60}, {188, 136, 82}, {216, 168, 108}, {234, 196, 140}, {246, 220, 178}}};
constexpr Ramp kSea{
    {{72, 104, 118}, {98, 136, 146}, {126, 164, 168}, {158, 190, 188}, {196, 216, 208}}};
constexpr Ramp kRose{
    {{140, 76, 76}, {178, 104, 96}, {206, 134, 120}, {224, 166, 150}, {238, 198, 182}}};
constexpr Ramp kPearl{
    {{136, 132, 134}, {164, 160, 156}, {190, 185, 176}, {210, 205, 194}, {228, 224, 214}}};
constexpr Ramp kLead{{{48, 48, 58}, {64, 64, 74}, {82, 82, 90}, {106, 106, 112}, {140, 140, 142}}};

/// The sky's light behind a pane, uneven.
Rgb glowing(const Ramp& pane, int tone, int x, int y) {
  return shade(pane, tone + cloudNoise(x, y, {kTileSide, kTileSide, 32, 32}, 181) / 3, x, y);
}

// Leaded panes in lozenges, a colour to each. No two that touch are alike, nor do those of one
// colour lie in a row.
Rgb lozengePixel(int x, int y) {
  using Row = std::array<const Ramp*, 4>;
  static constexpr std::array<Row, 4> kMix{{{&kAmber, &kPearl, &kSea, &kRose},
                                            {&kSea, &kAmber, &kPearl, &kSea},
                                            {&kPearl, &kRose, &kAmber, &kPearl},
                                            {&kRose, &kSea, &kPearl, &kAmber}}};
  const int rising = wrap(x + y + kPane / 2, kTileSide);
  const int falling = wrap(x - y + kPane / 2, kTileSide);
  const int lead = std::min(rising % kPane, falling % kPane);
  if (lead < 3) return shade(kLead, lead == 0 ? 170 : 110 - 40 * lead, x, y);
  const Ramp& ramp =
      *kMix[static_cast<std::size_t>(rising / kPane)][static_cast<std::size_t>(falling / kPane)];
  return glowing(ramp, 150 - rising % kPane, x, y);
}

/// Pixels to the outline of the window, whose head rises by 7 on 5 to a point.
int depthInWindow(int across, int y) {
  const int toHead = (5 * y - 7 * across) * 10 / 86;  // 86 is 10 times the root of 5 * 5 + 7 * 7
  return std::min({kTileSide / 2 - 1 - across, kWindowHeight - 1 - y, toHead});
}

/// A rose of eight petals within a ring of sixteen panes; `reach` is the square of the distance
/// from its middle. The border of two petals has a tangent of 5 / 12.
const Ramp& rosePane(int dx, int dy, int reach) {
  const int major = std::max(std::abs(dx), std::abs(dy));
  const int minor = std::min(std::abs(dx), std::abs(dy));
  const bool isUpright = 12 * minor < 5 * major;
  const bool isBetween = std::abs(12 * minor - 5 * major) < 16;
  if (reach < 8 * 8) return kAmber;
  if (reach < 10 * 10 || isBetween) return kLead;
  if (reach < 29 * 29) return isUpright ? kRose : kSea;
  if (reach < 31 * 31 || minor < 1 || major - minor < 2) return kLead;
  return reach < 41 * 41 ? (isUpright ? kPearl : kAmber) : kLead;
}

/// A saint in robe and mantle: `across` and `down` count from the middle of the halo.
const Ramp* saintPane(int across, int down) {
  const int reach = across * across + down * down;
  if (reach < 6 * 6) return &kPearl;
  if (reach < 8 * 8) return &kLead;
  const int robe = 7 + (down - 8) / 8;
  if (down > 7 && across < robe + 12) {
    if (across < robe) return down % 28 < 2 && across > 2 ? &kLead : &kRose;
    const int mantle = robe + std::min(down - 8, 8);
    if (across < robe + 2 || across >= mantle) return across < mantle + 2 ? &kLead : nullptr;
    return &kSea;
  }
  if (reach < 13 * 13) return &kAmber;
  return reach < 15 * 15 ? &kLead : nullptr;
}

/// The ground that rose and saint stand in: pale quarries, here and there one of colour.
const Ramp& quarryPane(int across, int y) {
  constexpr int kQuarry = 20;
  const int rising = y + across + kQuarry / 2;
  const int falling = y - across + 4 * kQuarry + kQuarry / 2;
  if (std::min(rising % kQuarry, falling % kQuarry) < 2) return kLead;
  const int lot = pick(rising / kQuarry, falling / kQuarry, 185, 7);
  return lot == 0 ? kAmber : lot < 3 ? kSea : kPearl;
}

const Ramp& windowPane(int dx, int y) {
  constexpr int kRoseY = 102;
  constexpr int kHaloY = 172;
  constexpr int kBead = 16;
  const int across = std::abs(dx);
  const int depth = depthInWindow(across, y);
  if (depth < 3 || depth == 11 || depth == 12) return kLead;
  if (depth < 11) {
    const int along = kWindowHeight - 1 - y < 11 ? across + kBead / 2 : y;
    if (along % kBead < 2) return kLead;
    return along / kBead % 2 == 0 ? kRose : kAmber;
  }
  const int reach = dx * dx + (y - kRoseY) * (y - kRoseY);
  if (reach < 43 * 43) return rosePane(dx, y - kRoseY, reach);
  if (const Ramp* pane = saintPane(across, y - kHaloY)) return *pane;
  return quarryPane(across, y);
}

Rgb windowPixel(int x, int y) {
  const int dx = x < kTileSide / 2 ? x - kTileSide / 2 + 1 : x - kTileSide / 2;
  const Ramp& pane = windowPane(dx, y);
  return &pane == &kLead ? shade(kLead, 90, x, y) : glowing(pane, 140, x, y);
}

}  // namespace

Image makeGlass() { return paintTile(lozengePixel); }

Image makeWindow() { return paintTile(windowPixel, kWindowHeight); }

}  // namespace hearth::textures
