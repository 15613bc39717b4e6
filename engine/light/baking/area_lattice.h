#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include "light/baking/light_visibility.h"
#include "light/gather/area_visibility.h"
#include "light/gather/light_lattice.h"
#include "light/light_cost.h"
#include "light/lit_surface.h"
#include "light/rays/id_set.h"
#include "light/sampling/sample_placement.h"

namespace hearth {

/// Which fraction of each light that is an area arrives at the samples of a surface or of a patch
/// of a mesh: found at the nodes of a lattice.
class AreaLattice {
 public:
  /// Asks `areas` for the fractions at a place; false if no light is there.
  using FindAt =
      std::function<bool(const SamplePoint& at, AreaVisibility& areas, std::span<double> fractions,
                         std::int64_t& slices, SectorSet& met)>;

  /// Keeps a reference to `places`, SurfacePlaces or PatchPlaces, of which samples that are left
  /// out have no light.
  template <typename Places>
  AreaLattice(const Scene& scene, const LightVisibilities& visibilities, const Places& places,
              FindAt findAt)
      : surface_(places.surface()),
        areas_(visibilities.areas()),
        fineness_(finenessFor(visibilities.purpose())),
        lattice_(
            surface_.texels, fineness_.cells, tolerances(scene, visibilities.gatherError()),
            [this, &places, find = std::move(findAt)](int i, int j, std::span<double> fractions) {
              const SamplePoint at = places.place({i + 0.5, j + 0.5});
              return !(places.mayLeaveOut() && places.isLeftOut(at)) &&
                     find(at, areas_, fractions, slices_, met_);
            }) {}
  AreaLattice(const AreaLattice&) = delete;
  AreaLattice& operator=(const AreaLattice&) = delete;

  /// Of a light that is an area. Counts the sample, and all slices that it takes.
  double seenFraction(std::size_t light, const SamplePoint& at, LightCost& cost);

  /// The sectors that slices have entered so far.
  const SectorSet& met() const { return met_; }

 private:
  /// Of the lattice.
  struct Fineness {
    LightLattice::Cells cells;
    double levels;           ///< by which interpolation may be off if the gather error is 1
    double levelsOfBounced;  ///< the same of light that bounces
  };

  static Fineness finenessFor(LightVisibilities::Purpose purpose);
  std::vector<double> tolerances(const Scene& scene, double gatherError) const;

  const LitSurface& surface_;
  AreaVisibility areas_;
  Fineness fineness_;
  std::int64_t slices_ = 0;  ///< that are not counted yet
  SectorSet met_;
  LightLattice lattice_;
};

}  // namespace hearth
