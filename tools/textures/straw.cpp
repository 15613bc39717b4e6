#include <cstddef>
#include <cstdlib>
#include <vector>

#include "textures/noise.h"
#include "textures/paint.h"
#include "textures/sprites.h"

namespace hearth::textures {
namespace {

constexpr int kSide = 128;
constexpr int kStalks = 210;

constexpr Ramp kYellow{
    {{112, 88, 44}, {152, 124, 64}, {186, 156, 88}, {210, 184, 118}, {230, 210, 156}}};

/// In 1.5 times [-range, range], near 0 rather than far from it.
int nearMiddle(int stalk, int what, int range) {
  int sum = 0;
  for (int i = 0; i < 3; ++i) sum += pick(stalk, 8 * what + i, 261, 2 * range + 1) - range;
  return sum / 2;
}

std::size_t indexOf(int x, int y) {
  return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x);
}

void layStalk(Image& image, std::vector<bool>& isStraw, int stalk) {
  const int x0 = kSide / 2 + nearMiddle(stalk, 1, 48);
  const int y0 = kSide / 2 + nearMiddle(stalk, 2, 48);
  const int length = 10 + pick(stalk, 2, 261, 16);
  const int alongX = pick(stalk, 3, 261, 513) - 256;
  const int alongY = (256 - std::abs(alongX)) * (pick(stalk, 4, 261, 2) == 0 ? 1 : -1);
  const int tone = 90 + pick(stalk, 5, 261, 130);
  for (int i = -length; i < length; ++i) {
    const int x = x0 + i * alongX / 256;
    const int y = y0 + i * alongY / 256;
    if (x < 1 || y < 1 || x >= kSide - 1 || y >= kSide - 1) continue;
    image.at(x, y) = shade(kYellow, tone - (i == length - 1 ? 40 : 0), x, y);
    isStraw[indexOf(x, y)] = true;
  }
}

}  // namespace

// Stalk over stalk, dense in the middle and few at the edge.
Image makeStraw() {
  Image image(kSide, kSide, kYellow[1]);
  std::vector<bool> isStraw(std::size_t{kSide} * kSide);
  for (int stalk = 0; stalk < kStalks; ++stalk) layStalk(image, isStraw, stalk);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (!isStraw[indexOf(x, y)]) image.makeHole(x, y);
  return image;
}

}  // namespace hearth::textures
