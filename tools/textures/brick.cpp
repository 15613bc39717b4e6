#include <array>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kBrickWidth = 32;
constexpr int kCourse = 16;
constexpr int kJoint = 2;

constexpr Ramp kRed{{{96, 54, 48}, {140, 78, 62}, {176, 102, 76}, {202, 130, 96}, {226, 164, 124}}};
constexpr Ramp kOchre{
    {{104, 62, 50}, {148, 88, 66}, {184, 116, 82}, {210, 144, 104}, {232, 178, 134}}};
constexpr Ramp kPlum{{{93, 52, 48}, {135, 76, 63}, {170, 99, 77}, {196, 126, 97}, {220, 159, 125}}};
constexpr Ramp kMortar{
    {{112, 98, 86}, {142, 126, 110}, {168, 152, 132}, {186, 172, 152}, {204, 192, 172}}};

const Ramp& rampOf(int brick, int course) {
  static constexpr std::array<const Ramp*, 6> kMix{&kRed, &kRed, &kOchre, &kRed, &kPlum, &kOchre};
  return *kMix[static_cast<std::size_t>(pick(brick, course, 11, 6))];
}

Rgb pixelAt(int x, int y) {
  // The image's edges run through the middle of bricks: joints stand out least there.
  const int course = wrap(y + kCourse / 2, kTileSide) / kCourse;
  const int along = wrap(x + kBrickWidth / 4 + (course % 2) * kBrickWidth / 2, kTileSide);
  const int brick = along / kBrickWidth;
  const BlockPixel pixel{along % kBrickWidth, wrap(y + kCourse / 2, kCourse), kBrickWidth - kJoint,
                         kCourse - kJoint};

  const int rough = smoothNoise(x, y, {kTileSide, kTileSide, 4, 4}, 12);
  const int speck = pick(x, y, 13, 100);
  const int distance = edgeDistance(pixel);
  const bool chipped = distance == 0 && rough > 76;
  if (distance < 0 || inCorner(pixel) || chipped) {
    const int shadowed = pixel.y == pixel.height ? -40 : 0;  // under the brick above
    return shade(kMortar, 128 + shadowed + rough / 4 + (speck < 8 ? 30 : 0), x, y);
  }
  const int clouds = cloudNoise(x + 40 * brick, y, {kTileSide, kTileSide, 16, 8}, 14);
  int tone = 122 + pick(brick, course, 15, 44) - 22 + clouds / 4 + bevel(pixel, 44);
  if (distance > 1 && speck < 5) tone -= 44;   // pores
  if (distance > 1 && speck > 96) tone += 30;  // grit
  return shade(rampOf(brick, course), tone, x, y);
}

}  // namespace

Image makeBrick() { return paintTile(pixelAt); }

}  // namespace hearth::textures
