#include "light/gather/irradiance_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hearth {

namespace {

constexpr std::size_t kPerCell = 4;

std::size_t cellAt(int width, int i, int j) {
  return kPerCell * (static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(i));
}

}  // namespace

IrradianceMap::IrradianceMap(const LitSurface& surface, const TexelRect& rect)
    : grid_(surface.grid), anchor_(surface.anchor), normal_(surface.normal), rect_(rect) {
  mips_.push_back({rect.width, rect.height,
                   std::vector<float>(kPerCell * static_cast<std::size_t>(rect.count()))});
}

void IrradianceMap::set(int i, int j, Vec3 levels) {
  float* cell = finestAt(i, j);
  for (const double value : {levels.x, levels.y, levels.z, 1.0})
    *cell++ = static_cast<float>(value);
  isDark_ &= levels == Vec3{};
}

void IrradianceMap::leaveOut(int i, int j) { std::fill_n(finestAt(i, j), kPerCell, 0.0F); }

float* IrradianceMap::finestAt(int i, int j) {
  Mip& finest = mips_.front();
  return &finest.cells[cellAt(finest.width, i - rect_.i0, j - rect_.j0)];
}

void IrradianceMap::finish() {
  while (mips_.back().width > 1 || mips_.back().height > 1) {
    const Mip& fine = mips_.back();
    Mip coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    coarse.cells.resize(cellAt(coarse.width, 0, coarse.height));
    for (int j = 0; j < fine.height; ++j)
      for (int i = 0; i < fine.width; ++i)
        for (std::size_t k = 0; k < kPerCell; ++k)
          coarse.cells[cellAt(coarse.width, i / 2, j / 2) + k] +=
              fine.cells[cellAt(fine.width, i, j) + k];
    mips_.push_back(std::move(coarse));
  }
}

/// The mean over about so many texels around a point, interpolated between cells.
Vec3 IrradianceMap::levelsAt(Vec2 texels, double width) const {
  std::size_t index = 0;
  double side = 1;
  for (; index + 1 < mips_.size() && 2 * side <= width; ++index) side *= 2;
  const Mip& mip = mips_[index];
  const double x = std::clamp((texels.x - rect_.i0) / side - 0.5, 0.0, mip.width - 1.0);
  const double y = std::clamp((texels.y - rect_.j0) / side - 0.5, 0.0, mip.height - 1.0);
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  std::array<double, kPerCell> sum{};
  const auto add = [&](int column, int row, double weight) {
    if (!(weight > 0)) return;
    const float* cell = &mip.cells[cellAt(mip.width, column, row)];
    for (std::size_t k = 0; k < kPerCell; ++k) sum[k] += weight * cell[k];
  };
  const double right = x - i;
  const double down = y - j;
  add(i, j, (1 - right) * (1 - down));
  add(i + 1, j, right * (1 - down));
  add(i, j + 1, (1 - right) * down);
  add(i + 1, j + 1, right * down);
  return sum[3] > 0 ? (1 / sum[3]) * Vec3{sum[0], sum[1], sum[2]} : Vec3{};
}

}  // namespace hearth
