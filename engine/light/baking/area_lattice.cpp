#include "light/baking/area_lattice.h"

namespace hearth {

/// How far the fractions may be off: as much as makes a level.
std::vector<double> AreaLattice::tolerancesOf(const Level& level,
                                              std::span<const std::size_t> lights) {
  constexpr double kTolerance = 1;  // level
  std::vector<double> tolerances;
  for (const std::size_t i : lights) tolerances.push_back(fractionFor(kTolerance, level.lights[i]));
  return tolerances;
}

double AreaLattice::seenFraction(std::size_t light, const SamplePoint& at, LightCost& cost) {
  const double seen = lattice_.at(surface_.grid.toTexels(at.point), areas_.placeOf(light));
  ++cost.samples;
  if (seen > 0) ++cost.seenSamples;
  cost.rays += std::exchange(slices_, 0);
  return seen;
}

}  // namespace hearth
