#include <algorithm>
#include <array>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kCourse = 32;
constexpr int kJoint = 2;
constexpr int kBlocks = 3;  // of a course

// Where each course's blocks begin. No joint lies above another, none at the image's edge.
constexpr std::array<std::array<int, kBlocks>, 4> kBegins{
    {{20, 64, 104}, {42, 84, 122}, {12, 56, 94}, {34, 74, 114}}};

constexpr Ramp kSand{
    {{98, 88, 80}, {136, 123, 109}, {168, 154, 134}, {194, 180, 158}, {220, 207, 186}}};
constexpr Ramp kRose{
    {{98, 87, 80}, {137, 122, 110}, {169, 152, 135}, {195, 178, 159}, {220, 205, 186}}};
constexpr Ramp kPale{
    {{98, 89, 81}, {135, 125, 111}, {167, 155, 137}, {194, 182, 162}, {220, 208, 189}}};
constexpr Ramp kMortar{
    {{90, 81, 73}, {110, 100, 89}, {130, 119, 106}, {148, 137, 123}, {166, 155, 140}}};
constexpr Ramp kWet{
    {{74, 76, 74}, {104, 107, 102}, {134, 137, 128}, {162, 164, 152}, {190, 191, 178}}};
constexpr Ramp kMoss{
    {{62, 70, 52}, {88, 98, 68}, {114, 124, 86}, {142, 150, 108}, {174, 180, 138}}};

struct Stone {
  BlockPixel pixel;
  int block;
  int course;
};

Stone stoneAt(int x, int y) {
  const int shifted = wrap(y + kCourse / 2, kTileSide);
  const int course = shifted / kCourse;
  const auto& begins = kBegins[static_cast<std::size_t>(course)];
  int block = kBlocks - 1;  // the last one runs on past the edge
  for (int i = 0; i < kBlocks - 1; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (x >= begins[at] && x < begins[at + 1]) block = i;
  }
  const int begin = begins[static_cast<std::size_t>(block)];
  const int end = begins[static_cast<std::size_t>((block + 1) % kBlocks)];
  return {{wrap(x - begin, kTileSide), shifted % kCourse, wrap(end - begin, kTileSide) - kJoint,
           kCourse - kJoint},
          block,
          course};
}

bool isJoint(const Stone& stone, int rough) {
  const int distance = edgeDistance(stone.pixel);
  return distance < 0 || inCorner(stone.pixel) || (distance == 0 && rough > 84);
}

int roughAt(int x, int y) { return smoothNoise(x, y, {kTileSide, kTileSide, 4, 4}, 81); }

int toneOf(const Stone& stone, int x, int y, int rough) {
  const Grain broad{kTileSide, kTileSide, 16, 16};
  const int clouds =
      cloudNoise(x, y, broad, 82 + static_cast<unsigned>(5 * stone.course + stone.block));
  // The mason's strokes, which slope down to the left.
  const int stroke = smoothNoise(x + y, y, {kTileSide, kTileSide, 2, 8}, 83);
  int tone = 134 + pick(stone.block, stone.course, 84, 30) - 15 + clouds / 6 + rough / 14 +
             bevel(stone.pixel, 40);
  if (edgeDistance(stone.pixel) > 2 && stroke > 84) tone -= 16;
  return tone;
}

Rgb cutStone(int x, int y) {
  static constexpr std::array<const Ramp*, 4> kMix{&kSand, &kPale, &kSand, &kRose};
  const Stone stone = stoneAt(x, y);
  const int rough = roughAt(x, y);
  if (isJoint(stone, rough)) return shade(kMortar, 128 + rough / 4, x, y);
  const auto ramp = static_cast<std::size_t>(pick(stone.block, stone.course, 85, 4));
  return shade(*kMix[ramp], toneOf(stone, x, y, rough), x, y);
}

/// How wet the walls are: 256 where they stand in moss, 0 where they are dry.
constexpr int kWetThrough = 256;

/// The same stones, wet, with moss that spreads from the joints and the stones' lower edges.
Rgb overgrownStone(int x, int y, int wetness) {
  const Stone stone = stoneAt(x, y);
  const int rough = roughAt(x, y);
  const bool joint = isJoint(stone, rough);
  const int patches = cloudNoise(x, y, {kTileSide, kTileSide, 64, 32}, 86);
  const int fromBelow = stone.pixel.height - stone.pixel.y;
  const int damp = std::max(0, 10 - std::max(0, edgeDistance(stone.pixel))) * 5 +
                   std::max(0, 12 - std::max(0, fromBelow)) * 3;
  const int moss = patches / 2 + damp + rough / 4 - 30 - (kWetThrough - wetness) / 3;
  if (moss > 8)
    return shade(kMoss, 118 + rough / 4 + std::min(moss, 60) / 2 - (joint ? 40 : 0), x, y);
  const Rgb wet = joint ? shade(kMortar, 78 + rough / 4, x, y)
                        : shade(kWet, toneOf(stone, x, y, rough) - (moss > -4 ? 24 : 4), x, y);
  return blend(cutStone(x, y), wet, wetness);
}

/// Down a wall from dry stone to wet and back, twice: moss that ends in tongues.
Rgb stoneAboveMoss(int x, int y) {
  const int tongues = cloudNoise(x, 0, {kTileSide, 8, 32, 8}, 87) / 3;
  const int fromDry = kCourse - std::abs(wrap(y - kCourse / 2, 2 * kCourse) - kCourse);
  const int damp = std::clamp(fromDry + tongues - 6, 0, kCourse - 12);
  return overgrownStone(x, y, damp * kWetThrough / (kCourse - 12));
}

}  // namespace

Image makeAshlar() { return paintTile(cutStone); }

Image makeMossy() {
  return paintTile([](int x, int y) { return overgrownStone(x, y, kWetThrough); });
}

Image makeMossline() { return paintTile(stoneAboveMoss); }

}  // namespace hearth::textures
