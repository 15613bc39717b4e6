#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/sprites.h"

namespace hearth::textures {
namespace {

constexpr int kWidth = 16;
constexpr int kHeight = 512;
constexpr int kPair = 24;    // pixels down from a link to the next but one
constexpr int kFlat = 15;    // the height of the links that show their eye
constexpr int kEdgeOn = 11;  // where the other ones begin

constexpr Ramp kForged{
    {{44, 44, 50}, {80, 82, 88}, {118, 120, 124}, {156, 156, 156}, {204, 202, 196}}};

/// In half pixels to the right of the chain's axis.
int aside(int x) { return 2 * x - kWidth + 1; }

bool isFlatLink(int x, int down) {
  const int reach = std::abs(aside(x));
  const bool isEnd = down < 3 || down >= kFlat - 3;
  const bool isCorner = down == 0 || down == kFlat - 1;
  return down < kFlat && reach <= (isCorner ? 3 : 5) && (isEnd || reach > 1);
}

bool isEdgeOn(int x, int down) {
  return std::abs(aside(x)) <= 1 && (down >= kEdgeOn || down < kFlat - kEdgeOn);
}

}  // namespace

// Round links, in turn flat and on edge, lit from the left.
Image makeChain() {
  Image image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int down = y % kPair;
      const int rust = smoothNoise(x, y, {kWidth, kHeight, 4, 4}, 251) / 5;
      const int round = isEdgeOn(x, down) ? -40 * aside(x) : -12 * aside(x);
      image.at(x, y) = shade(kForged, 120 + round + rust - (down < 2 ? 30 : 0), x, y);
      if (!isFlatLink(x, down) && !isEdgeOn(x, down)) image.makeHole(x, y);
    }
  return image;
}

}  // namespace hearth::textures
