#pragma once

#include <vector>

#include "level/scene.h"
#include "truth/trace.h"

namespace hearth {

/// What a point of a surface sees round it: points of other surfaces, in fixed directions.
class Outlook {
 public:
  /// Keeps the scene.
  Outlook(const Scene& scene, const SurfacePoint& place);

  /// Whether any of them gets visible light from it, a ball being a point.
  bool isLitBy(const LightSource& light) const;

 private:
  Scene scene_;
  std::vector<SurfacePoint> seen_;
};

/// Directions of an outlook: as many rays does it take at most to ask for a light.
inline constexpr int kOutlookRays = 32;

}  // namespace hearth
