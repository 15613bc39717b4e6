#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <vector>

#include "peers/level_mesh.h"

namespace hearth {

using Float3 = std::array<float, 3>;

struct FloatRay {
  Float3 origin;
  Float3 direction;
};

/// A mesh in Embree, in single precision.
class EmbreeScene {
 public:
  /// Keeps a pointer to the mesh.
  explicit EmbreeScene(std::vector<MeshTriangle>& mesh);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  /// The first triangle of the mesh that the ray meets from its front, or null.
  const MeshTriangle* firstMet(const FloatRay& ray) const;

 private:
  const std::vector<MeshTriangle>& mesh_;
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace hearth
