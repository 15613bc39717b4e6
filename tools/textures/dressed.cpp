#include <array>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kCourse = 32;
constexpr int kJoint = 1;
constexpr int kLength = 64;

// Where each course's first joint is. None lies above another, none at the image's edge.
constexpr std::array<int, 4> kBegins{20, 50, 8, 38};

constexpr Ramp kLimestone{
    {{98, 96, 93}, {130, 128, 123}, {160, 157, 150}, {184, 181, 172}, {210, 207, 197}}};

Rgb pixelAt(int x, int y) {
  const int shifted = wrap(y + kCourse / 2, kTileSide);
  const int course = shifted / kCourse;
  const int below = shifted % kCourse;
  const int rough = smoothNoise(x, y, {kTileSide, kTileSide, 4, 4}, 191);
  const int along = wrap(x - kBegins[static_cast<std::size_t>(course)], kTileSide);
  const int within = along % kLength;
  if (below >= kCourse - kJoint || within < kJoint) return shade(kLimestone, 20 + rough / 6, x, y);
  const int clouds = cloudNoise(x + 37 * course, y, {kTileSide, kTileSide, 32, 16}, 192);
  const int tooling = smoothNoise(x - y, y, {kTileSide, kTileSide, 2, 8}, 195);
  int tone = 140 + pick(course, along / kLength, 196, 24) - 12 + clouds / 7 + tooling / 14;
  if (below == 0) tone += 30;                     // light caught by the upper edge
  if (below == kCourse - kJoint - 1) tone -= 34;  // the lower edge
  if (within == kJoint) tone += 16;
  if (within == kLength - 1) tone -= 18;
  return shade(kLimestone, tone, x, y);
}

}  // namespace

// The edges of the image lie where the tooling is faint.
Image makeDressed() {
  return paintTile([](int x, int y) { return pixelAt(wrap(x + 68, kTileSide), y); });
}

}  // namespace hearth::textures
