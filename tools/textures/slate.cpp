#include <array>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

constexpr int kCourse = 16;
constexpr int kWidth = 16;

constexpr Ramp kBlue{
    {{70, 74, 92}, {98, 102, 120}, {126, 130, 145}, {154, 156, 166}, {186, 186, 190}}};
constexpr Ramp kViolet{
    {{74, 72, 90}, {102, 100, 117}, {130, 127, 142}, {157, 154, 164}, {188, 184, 189}}};
constexpr Ramp kGreen{
    {{71, 77, 88}, {99, 105, 115}, {126, 133, 140}, {154, 159, 162}, {186, 188, 187}}};

// Square slates in courses: each throws a shadow on the one below, and no two lie quite as deep.
Rgb pixelAt(int x, int y) {
  static constexpr std::array<const Ramp*, 5> kMix{&kBlue, &kViolet, &kBlue, &kGreen, &kBlue};
  const int shifted = wrap(y + kCourse / 2, kTileSide);
  const int course = shifted / kCourse;
  const int along = wrap(x + kWidth / 4 + (course % 2) * kWidth / 2, kTileSide);
  const int slate = along / kWidth;
  const int column = along % kWidth;
  const int below = shifted % kCourse;
  const int edge = kCourse - 1 - below - pick(slate, course, 171, 3);  // rows to its lower edge
  const int clouds = cloudNoise(x, y, {kTileSide, kTileSide, 8, 8}, 172);
  int tone = 122 + pick(slate, course, 175, 50) - 25 + clouds / 7 + 2 * below;
  if (edge < 0) tone -= 50;   // the shadow
  if (edge == 0) tone += 30;  // its rim
  if (column == 0) tone -= 50;
  if (column == 1) tone += 14;
  return shade(*kMix[static_cast<std::size_t>(pick(slate, course, 176, 5))], tone, x, y);
}

}  // namespace

Image makeSlate() { return paintTile(pixelAt); }

}  // namespace hearth::textures
