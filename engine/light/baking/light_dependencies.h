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

 private:
  std::map<std::size_t, SectorSet> sectors_;  ///< by light
  SurfaceSet surfaces_;
};

}  // namespace hearth
