#include "textures/noise.h"

#include "math/check.h"

namespace hearth::textures {
namespace {

/// The smoothstep 3t^2 - 2t^3 in 1/256, for `t` = `step`/`cell`.
int eased(int step, int cell) {
  const int t = 256 * step / cell;
  return t * t * (768 - 2 * t) / 65536;
}

int mixed(int a, int b, int weight256) { return (a * (256 - weight256) + b * weight256) / 256; }

}  // namespace

// The finalizer of MurmurHash3 (Austin Appleby, public domain) over a linear mix.
std::uint32_t hash(int x, int y, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1U ^
                    static_cast<std::uint32_t>(y) * 0x85EBCA77U ^ seed * 0xC2B2AE3DU;
  h = (h ^ (h >> 16)) * 0x85EBCA6BU;
  h = (h ^ (h >> 13)) * 0xC2B2AE35U;
  return h ^ (h >> 16);
}

int pick(int x, int y, std::uint32_t seed, int range) {
  return static_cast<int>(hash(x, y, seed) % static_cast<std::uint32_t>(range));
}

int smoothNoise(int x, int y, Grain grain, std::uint32_t seed) {
  CHECK(grain.width % grain.cellX == 0 && grain.height % grain.cellY == 0, grain.width,
        grain.height, grain.cellX, grain.cellY);
  const int px = wrap(x, grain.width);
  const int py = wrap(y, grain.height);
  const int column = px / grain.cellX;
  const int row = py / grain.cellY;
  const int nextColumn = (column + 1) % (grain.width / grain.cellX);
  const int nextRow = (row + 1) % (grain.height / grain.cellY);

  const auto corner = [seed](int i, int j) { return pick(i, j, seed, 256) - 128; };
  const int weightX = eased(px % grain.cellX, grain.cellX);
  const int top = mixed(corner(column, row), corner(nextColumn, row), weightX);
  const int bottom = mixed(corner(column, nextRow), corner(nextColumn, nextRow), weightX);
  return mixed(top, bottom, eased(py % grain.cellY, grain.cellY));
}

int cloudNoise(int x, int y, Grain grain, std::uint32_t seed) {
  const Grain half{grain.width, grain.height, grain.cellX / 2, grain.cellY / 2};
  const Grain quarter{grain.width, grain.height, grain.cellX / 4, grain.cellY / 4};
  return (4 * smoothNoise(x, y, grain, seed) + 2 * smoothNoise(x, y, half, seed + 1) +
          smoothNoise(x, y, quarter, seed + 2)) /
         6;
}

}  // namespace hearth::textures
