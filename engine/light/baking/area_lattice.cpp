#include "light/baking/area_lattice.h"

#include "math/check.h"

namespace hearth {

AreaLattice::Fineness AreaLattice::finenessFor(LightVisibilities::Purpose purpose) {
  // Texels along the sides of cells: a metre of texels as large as they are by default.
  constexpr int kSide = 8;
  // Half of the surfaces of a level with models are no wider than two texels.
  constexpr int kNarrowSurface = 2;
  switch (purpose) {
    case LightVisibilities::Purpose::Bake:
      return {{.side = kSide, .narrow = kNarrowSurface, .areDivided = true}, 1, 3};
    case LightVisibilities::Purpose::Source:
      return {{.side = 4 * kSide, .narrow = kSide / 2, .areDivided = true}, 4, 8};
    case LightVisibilities::Purpose::Draft:
      return {{.side = kSide, .narrow = kNarrowSurface, .areDivided = false}, 1, 3};
  }
  CHECK(false, static_cast<int>(purpose));
}

/// How far the fractions may be off. Light that bounces has no hard edges that would show it.
std::vector<double> AreaLattice::tolerances(const Scene& scene, double gatherError) const {
  std::vector<double> tolerances;
  for (const std::size_t i : areas_.lights()) {
    const LightSource& light = scene.lights()[i];
    const double levels = light.isBounced ? fineness_.levelsOfBounced : fineness_.levels;
    tolerances.push_back(fractionFor(gatherError * levels, light));
  }
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
