#include <array>
#include <string_view>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

// One letter per stone on a grid of four by four cells, which wraps around on both sides.
constexpr std::array<std::string_view, 4> kPlan{"AABC",  //
                                                "AADC",  //
                                                "EFFG",  //
                                                "HFFG"};
// Where the grid's lines run, in pixels. Uneven, so that no two stones are alike.
constexpr std::array<int, 5> kLines{0, 30, 66, 100, 128};
constexpr int kShift = 15;  // brings the image's edges to the middle of stones
constexpr int kJoint = 3;

constexpr Ramp kGrey{
    {{88, 84, 82}, {118, 112, 107}, {148, 141, 133}, {175, 168, 158}, {204, 198, 186}}};
constexpr Ramp kWarm{
    {{92, 84, 77}, {124, 114, 103}, {155, 143, 128}, {182, 170, 153}, {210, 199, 182}}};
constexpr Ramp kCool{
    {{84, 84, 87}, {112, 112, 115}, {141, 140, 140}, {168, 167, 164}, {198, 197, 192}}};
constexpr Ramp kJointRamp{
    {{64, 58, 56}, {82, 76, 70}, {98, 90, 82}, {114, 106, 96}, {130, 122, 110}}};

int cellOf(int along) {
  int cell = 0;
  while (along >= kLines[static_cast<std::size_t>(cell) + 1]) ++cell;
  return cell;
}

char stoneAt(int column, int row) {
  return kPlan[static_cast<std::size_t>(wrap(row, 4))][static_cast<std::size_t>(wrap(column, 4))];
}

/// The extent of a stone along one axis, from the cell that holds the pixel.
struct Extent {
  int begin;
  int end;
};

template <typename SameStone>
Extent extentOf(int cell, SameStone same) {
  int first = cell;
  int last = cell;
  while (first > 0 && same(first - 1)) --first;
  while (last < 3 && same(last + 1)) ++last;
  return {kLines[static_cast<std::size_t>(first)], kLines[static_cast<std::size_t>(last) + 1]};
}

const Ramp& rampOf(char stone) {
  static constexpr std::array<const Ramp*, 4> kMix{&kGrey, &kWarm, &kGrey, &kCool};
  return *kMix[static_cast<std::size_t>(pick(stone, 0, 25, 4))];
}

Rgb pixelAt(int x, int y) {
  const int alongX = wrap(x + kShift, kTileSide);
  const int alongY = wrap(y + kShift, kTileSide);
  const int column = cellOf(alongX);
  const int row = cellOf(alongY);
  const char stone = stoneAt(column, row);
  const Extent extentX = extentOf(column, [&](int c) { return stoneAt(c, row) == stone; });
  const Extent extentY = extentOf(row, [&](int r) { return stoneAt(column, r) == stone; });
  const BlockPixel pixel{alongX - extentX.begin, alongY - extentY.begin,
                         extentX.end - extentX.begin - kJoint,
                         extentY.end - extentY.begin - kJoint};

  const int rough = smoothNoise(x, y, {kTileSide, kTileSide, 4, 4}, 21);
  const int distance = edgeDistance(pixel);
  if (distance < 0 || inCorner(pixel) || (distance == 0 && rough > 70)) {
    return shade(kJointRamp, 128 + rough / 2, x, y);
  }
  const int clouds =
      cloudNoise(x, y, {kTileSide, kTileSide, 16, 16}, 22 + static_cast<unsigned>(stone));
  // Chisel marks: short strokes that slope down to the left.
  const int stroke = smoothNoise(x + y, y, {kTileSide, kTileSide, 2, 8}, 23);
  int tone = 132 + pick(stone, 1, 24, 40) - 20 + clouds / 5 + bevel(pixel, 52);
  if (distance > 2 && stroke > 78) tone -= 24;
  if (distance > 2 && stroke < -88) tone += 20;
  return shade(rampOf(stone), tone, x, y);
}

}  // namespace

Image makeStone() { return paintTile(pixelAt); }

}  // namespace hearth::textures
