#include "textures/cells.h"

#include <algorithm>
#include <cstdlib>

#include "textures/noise.h"
#include "textures/textures.h"

namespace hearth::textures {
namespace {

struct Middle {
  int id = 0;
  int dx = 0;
  int dy = 0;
  int squared = 1 << 30;
};

Middle middleOf(int column, int row, int x, int y, int side, int jitter, std::uint32_t seed) {
  const int i = wrap(column, kTileSide / side);
  const int j = wrap(row, kTileSide / side);
  const int spare = (side - jitter) / 2;
  const int dx = x - column * side - spare - pick(i, j, seed, jitter);
  const int dy = y - row * side - spare - pick(i, j, seed + 1, jitter);
  return {pick(i, j, seed + 2, 1 << 16), dx, dy, dx * dx + dy * dy};
}

}  // namespace

Cell nearestCell(int x, int y, int side, int jitter, std::uint32_t seed) {
  Middle first;
  Middle second;
  for (int row = y / side - 2; row <= y / side + 2; ++row) {
    for (int column = x / side - 2; column <= x / side + 2; ++column) {
      const Middle middle = middleOf(column, row, x, y, side, jitter, seed);
      if (middle.squared < first.squared) {
        second = first;
        first = middle;
      } else if (middle.squared < second.squared) {
        second = middle;
      }
    }
  }
  // The bisector's distance is the difference of the squares over twice the middles' distance, for
  // which its octagonal norm will do.
  const int apartX = std::abs(first.dx - second.dx);
  const int apartY = std::abs(first.dy - second.dy);
  const int apart = std::max(apartX, apartY) + std::min(apartX, apartY) / 2;
  return {first.id, first.dx, first.dy, (second.squared - first.squared) / std::max(1, 2 * apart)};
}

}  // namespace hearth::textures
