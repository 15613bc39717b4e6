#pragma once

#include <cstddef>
#include <map>

#include "light/rays/id_set.h"

namespace hearth {

/// The parts of a level that the light on one surface depends on. While they, and the sectors that
/// they open to, stay as they are, so does the light.
class LightDependencies {
 public:
  /// The sectors that rays of a light enter, or might enter.
  SectorSet& sectorsOf(std::size_t light) { return sectors_[light]; }
  /// The surfaces on which places for samples were sought.
  SurfaceSet& surfaces() { return surfaces_; }
  /// The sectors that lines enter which tell whether a sample lies inside a mesh. They count for
  /// each light that reaches the surface, or might reach a sample that lies in one.
  SectorSet& sampleSectors() { return sampleSectors_; }
  bool isSampleInMesh() const { return isSampleInMesh_; }
  void addSampleInMesh() { isSampleInMesh_ = true; }

 private:
  std::map<std::size_t, SectorSet> sectors_;  ///< by light
  SurfaceSet surfaces_;
  SectorSet sampleSectors_;
  bool isSampleInMesh_ = false;
};

}  // namespace hearth
