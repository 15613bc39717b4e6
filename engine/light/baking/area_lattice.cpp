#include "light/baking/area_lattice.h"

#include <algorithm>

namespace hearth {

/// How far the fractions may be off: as much as makes a level.
std::vector<double> AreaLattice::tolerancesOf(const Level& level,
                                              std::span<const std::size_t> lights) {
  constexpr double kTolerance = 1;  // level
  std::vector<double> tolerances;
  for (const std::size_t i : lights) {
    const LightSource& light = level.lights[i];
    tolerances.push_back(kTolerance /
                         std::max(kTolerance, light.intensity * light.greatestFactor()));
  }
  return tolerances;
}

double AreaLattice::seenFraction(std::size_t light, const SamplePoint& at, LightCost& cost) {
  const auto place = std::ranges::lower_bound(areas_.lights(), light) - areas_.lights().begin();
  const double seen =
      lattice_.at(surface_.grid.toTexels(at.point), static_cast<std::size_t>(place));
  ++cost.samples;
  if (seen > 0) ++cost.seenSamples;
  cost.rays += std::exchange(slices_, 0);
  return seen;
}

}  // namespace hearth
