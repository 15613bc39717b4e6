#include "light/baking/area_lattice.h"

#include "math/check.h"

namespace hearth {

AreaLattice::Fineness AreaLattice::finenessFor(LightVisibilities::Purpose purpose) {
  using Parts = LightLattice::Parts;
  // Texels along the sides of cells: a metre of texels as large as they are by default.
  constexpr int kSide = 8;
  switch (purpose) {
    case LightVisibilities::Purpose::Bake:
      return {{kSide, 0, Parts::DownToOne}, 1};
    case LightVisibilities::Purpose::Source:
      return {{4 * kSide, kSide / 2, Parts::DownToTwo}, 4};
    case LightVisibilities::Purpose::Draft:
      return {{kSide, 0, Parts::None}, 1};
  }
  CHECK(false, static_cast<int>(purpose));
}

/// How far the fractions may be off: by what makes so many levels, or twice as many of light that
/// bounces, which has more of them.
std::vector<double> AreaLattice::tolerancesOf(const Scene& scene,
                                              std::span<const std::size_t> lights, double levels) {
  std::vector<double> tolerances;
  for (const std::size_t i : lights) {
    const LightSource& light = scene.lights()[i];
    tolerances.push_back(fractionFor(light.isBounced ? 2 * levels : levels, light));
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
