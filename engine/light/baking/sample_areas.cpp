#include "light/baking/sample_areas.h"

#include <cstdint>

namespace hearth {

AreaLattice& SampleAreas::lattice() {
  if (!lattice_)
    lattice_.emplace(rays_.scene(), rays_.visibilities(), places_,
                     [this](const SamplePoint& at, AreaVisibility& areas,
                            std::span<double> fractions, std::int64_t& slices, SectorSet& met) {
                       areas.findOnSurface(at.target, rays_.scene()[at.surface].sector,
                                           rays_.surface(at.surface).normal, fractions, slices,
                                           &met);
                       return true;
                     });
  return *lattice_;
}

void SampleAreas::find(std::size_t light, const SampleBlocks& blocks, std::span<double> seen) {
  AreaLattice& areas = lattice();
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (const SamplePoint& at = blocks.samples()[i]; !at.isSpare)
      seen[i] = areas.seenFraction(light, at, rays_.cost(light));
  recordMet(light);
}

double SampleAreas::seenFraction(std::size_t light, const SamplePoint& at) {
  const std::int64_t before = rays_.cost(light).rays;
  const double seen = lattice().seenFraction(light, at, rays_.cost(light));
  // Most samples lie between nodes that are known.
  if (rays_.cost(light).rays != before) recordMet(light);
  return seen;
}

void SampleAreas::recordMet(std::size_t light) {
  if (SectorSet* met = rays_.enteredSectors(light)) met->add(lattice().met());
}

}  // namespace hearth
