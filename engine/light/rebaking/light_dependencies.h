#pragma once

#include <cstddef>
#include <map>

#include "light/sight/id_set.h"

namespace hearth {

/// From which parts of a level the light on one surface was found. Where they, and what they open
/// to, stay as they are, so does the light.
class LightDependencies {
 public:
  /// Into which rays of a light come, or might.
  SectorSet& sectorsOf(std::size_t light) { return sectors_[light]; }
  /// On which places were sought for samples.
  SurfaceSet& surfaces() { return surfaces_; }

 private:
  std::map<std::size_t, SectorSet> sectors_;  ///< by light
  SurfaceSet surfaces_;
};

}  // namespace hearth
