#pragma once

#include <vector>

#include "level/scene.h"
#include "truth/trace.h"
#include "truth/truth_meshes.h"

namespace hearth {

/// The points of other surfaces that a point of a surface sees in fixed directions.
class HemisphereSample {
 public:
  /// Keeps the scene and a reference to its meshes.
  HemisphereSample(const Scene& scene, const TruthMeshes& meshes, const SurfacePoint& place);

  /// Whether any of these points gets visible light from a light; a ball counts as a point.
  bool isLitBy(const LightSource& light) const;

 private:
  Scene scene_;
  const TruthMeshes& meshes_;
  std::vector<SurfacePoint> seen_;
};

/// Directions of a sample, and the most rays that a test of one light takes.
inline constexpr int kHemisphereRays = 32;

}  // namespace hearth
