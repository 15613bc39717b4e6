#include <array>
#include <string_view>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

// One letter per stone on a grid of cells that wraps around on both sides. Every line of the grid
// is broken by stones that lie across it, so no joint runs on from one repeat to the next.
constexpr int kCells = 6;
constexpr std::array<std::string_view, kCells> kPlan{"NBBCCN",  //
                                                     "AAICCA",  //
                                                     "AADDHA",  //
                                                     "JGDDMK",  //
                                                     "EGDDFF",  //
                                                     "EBBLFF"};
// Where the grid's lines run, in pixels. Uneven, so that no two stones are alike.
constexpr std::array<int, kCells + 1> kLines{0, 20, 43, 62, 86, 107, 128};
constexpr int kShift = 10;  // brings the image's edges to the middle of stones
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
  return kPlan[static_cast<std::size_t>(wrap(row, kCells))]
              [static_cast<std::size_t>(wrap(column, kCells))];
}

/// Where the line before a cell runs; cells before and past the image repeat it.
int lineBefore(int cell) {
  const int repeat = (cell - wrap(cell, kCells)) / kCells;
  return kLines[static_cast<std::size_t>(wrap(cell, kCells))] + repeat * kTileSide;
}

/// The extent of a stone along one axis, in pixels; it may begin before the image or end past it.
struct Extent {
  int begin;
  int end;
};

template <typename SameStone>
Extent extentOf(int cell, SameStone same) {
  int first = cell;
  int last = cell;
  while (same(first - 1)) --first;
  while (same(last + 1)) ++last;
  return {lineBefore(first), lineBefore(last + 1)};
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
