// What hangs on walls: woven pictures. Threads are two pixels thick; coordinates below count
// threads.

#include <algorithm>
#include <array>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/sprites.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kThread = 2;
constexpr int kWidth = kTileSide / kThread;
constexpr int kBannerHeight = 640;
constexpr int kTapestryHeight = 352;
constexpr int kGonfalonWidth = 64;
constexpr int kGonfalonHeight = 128;

constexpr Ramp kGreen{
    {{44, 70, 56}, {62, 94, 74}, {84, 120, 94}, {112, 146, 118}, {146, 174, 146}}};
constexpr Ramp kLeaf{
    {{66, 84, 50}, {90, 112, 64}, {116, 138, 80}, {144, 162, 100}, {174, 186, 128}}};
constexpr Ramp kGold{
    {{126, 88, 54}, {164, 122, 74}, {196, 154, 98}, {218, 182, 128}, {236, 208, 162}}};
constexpr Ramp kLinen{
    {{138, 126, 104}, {164, 152, 128}, {188, 176, 152}, {206, 196, 174}, {222, 214, 196}}};
constexpr Ramp kBark{{{74, 52, 42}, {102, 74, 58}, {130, 98, 76}, {156, 124, 98}, {184, 152, 124}}};
constexpr Ramp kWine{
    {{96, 42, 50}, {130, 58, 64}, {160, 80, 80}, {186, 108, 102}, {212, 142, 132}}};

Rgb woven(const Ramp& wool, int x, int y) {
  const int weave = (x + y) % 4 < 2 ? 8 : -8;
  const int worn = cloudNoise(x, y, {kTileSide, kTileSide, 32, 32}, 171) / 6;
  return shade(wool, 128 + weave + worn, x, y);
}

/// Whether a tower of battlements, door and window stands there; `down` counts from its top.
bool isTower(int across, int down) {
  if (down < 0 || down >= 64) return false;
  if (down < 8) return across < 4 || (across >= 8 && across < 16);
  if (down < 16) return across < 16;
  const bool isWindow = down >= 24 && down < 34 && across < 2;
  const bool isDoor = down >= 46 && across < 5;
  return across < (down < 58 ? 12 : 15) && !isWindow && !isDoor;
}

// On green a golden tower, a star above it and chevrons below.
const Ramp& bannerWool(int across, int v) {
  constexpr int kTower = 84;
  const int edge = std::min({kWidth / 2 - 1 - across, v, kBannerHeight / kThread - 1 - v});
  if (edge < 2) return kWine;
  if (edge < 6) return kGold;
  const int star = std::abs(v - 52);
  if (std::min(across, star) * 3 + std::max(across, star) < 18) return kGold;
  if (isTower(across, v - kTower)) return kGold;
  const int chevron = v - across - 176;
  if (chevron >= 0 && chevron < 104 && chevron % 26 < 12) return chevron % 52 < 26 ? kWine : kGold;
  return kGreen;
}

struct Bough {
  int across;
  int v;
  int reach;
};

/// What grows at a place: boughs left and right of a trunk, with fruit in them.
const Ramp* treeWool(int across, int v) {
  static constexpr std::array<Bough, 6> kBoughs{
      {{0, 34, 13}, {11, 48, 11}, {0, 60, 14}, {14, 70, 11}, {0, 84, 12}, {13, 92, 9}}};
  for (const Bough& bough : kBoughs) {
    const int dx = across - bough.across;
    const int dy = v - bough.v;
    const int reach = dx * dx + dy * dy;
    if (reach >= bough.reach * bough.reach) continue;
    if (reach < 9) return &kGold;
    return reach >= (bough.reach - 2) * (bough.reach - 2) ? &kGreen : &kLeaf;
  }
  const int root = std::max(v - 136, 0) / 2;
  return v > 90 && v < 150 && across < 3 + root ? &kBark : nullptr;
}

const Ramp& tapestryWool(int across, int v) {
  constexpr int kBorder = 8;
  constexpr int kGround = 146;
  const int height = kTapestryHeight / kThread;
  const int edge = std::min({kWidth / 2 - 1 - across, v, height - 1 - v});
  if (edge < 1 || edge == kBorder - 1) return kGold;
  if (edge < kBorder) {
    const int bead = std::abs((across + v) % 8 - 4) + std::abs((v - across + 64) % 8 - 4);
    return bead < 3 ? kGold : kWine;
  }
  if (const Ramp* tree = treeWool(across, v)) return *tree;
  if (v > kGround - across * across / 64) {
    return pick(across / 2, v / 2, 175, 11) == 0 ? kGold : v % 12 < 6 ? kGreen : kLeaf;
  }
  return kLinen;
}

/// How many threads a pixel lies beside the middle of an image.
int threadsAcross(int x, int width = kTileSide) {
  return (x < width / 2 ? width / 2 - 1 - x : x - width / 2) / kThread;
}

Rgb bannerPixel(int x, int y) { return woven(bannerWool(threadsAcross(x), y / kThread), x, y); }

Rgb tapestryPixel(int x, int y) { return woven(tapestryWool(threadsAcross(x), y / kThread), x, y); }

/// Threads from there to the cut of a gonfalon's tail, which has two points.
int aboveTail(int across, int v) {
  const int end = kGonfalonHeight / kThread - 1;
  return end - std::max(0, 18 - 2 * across) - std::max(0, 2 * (across - 12)) - v;
}

// On wine a golden cross with a lozenge in its middle, below a rod.
const Ramp& gonfalonWool(int across, int v) {
  if (v < 3) return kBark;
  const int edge =
      std::min({kGonfalonWidth / kThread / 2 - 1 - across, aboveTail(across, v), v - 3});
  if (edge < 2) return kGold;
  const int down = std::abs(v - 22);
  if (across + down < 4) return kGreen;
  const bool isUpright = across < 2 + down / 6 && down < 14;
  const bool isBeam = down < 2 + across / 5 && across < 11;
  return isUpright || isBeam ? kGold : kWine;
}

}  // namespace

Image makeGonfalon() {
  Image image(kGonfalonWidth, kGonfalonHeight);
  for (int y = 0; y < kGonfalonHeight; ++y)
    for (int x = 0; x < kGonfalonWidth; ++x) {
      const int across = threadsAcross(x, kGonfalonWidth);
      const int v = y / kThread;
      image.at(x, y) = woven(gonfalonWool(across, v), x, y);
      if (aboveTail(across, v) < 0) image.makeHole(x, y);
    }
  return image;
}

Image makeBanner() { return paintTile(bannerPixel, kBannerHeight); }

Image makeTapestry() { return paintTile(tapestryPixel, kTapestryHeight); }

}  // namespace hearth::textures
