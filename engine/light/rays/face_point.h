#pragma once

#include <cstdint>

#include "math/vec.h"

namespace hearth {

/// A point of a mesh's face, to be lit.
struct FacePoint {
  Vec3 point;
  Vec3 normal;  ///< unit, out of the face's front
  std::uint32_t mesh;
};

}  // namespace hearth
