#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "light/baking/area_lattice.h"
#include "light/baking/sample_rays.h"
#include "light/baking/surface_places.h"

namespace hearth {

/// Finds which fraction of a light that is an area arrives at samples of a surface.
class SampleAreas {
 public:
  /// Keeps references to both.
  SampleAreas(SampleRays& rays, const SurfacePlaces& places) : rays_(rays), places_(places) {}

  /// For all samples, into `seen` by their indices.
  void find(std::size_t light, const SampleBlocks& blocks, std::span<double> seen);
  double seenFraction(std::size_t light, const SamplePoint& at);

 private:
  AreaLattice& lattice();
  void recordMet(std::size_t light);

  SampleRays& rays_;
  const SurfacePlaces& places_;
  std::optional<AreaLattice> lattice_;  ///< once it is asked
};

}  // namespace hearth
