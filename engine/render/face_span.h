#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "level/ids.h"
#include "level/mesh.h"
#include "math/vec.h"
#include "render/camera.h"
#include "render/face_gradient.h"
#include "render/segment_columns.h"

namespace hearth {

/// The corners of a face: metres ahead of the eye, to its right and up.
using FaceCorners = std::array<Vec3, 3>;

inline FaceCorners cornersBefore(const Projection& projection, const MeshFace& face) {
  FaceCorners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const CameraPoint at = projection.toCamera(face.corners[i].xy());
    corners[i] = {at.depth, at.lateral, face.corners[i].z - projection.eye().z};
  }
  return corners;
}

/// A face of a mesh before the eye. Rays are (1, slant, ray slope): 1 m ahead, to the right and up,
/// see Projection. Of a large model most are not in the cache when they are needed. So what tells
/// where a face shows lies together, in two cache lines, and what colours it behind that.
struct alignas(64) FaceFront {
  ColumnRange columns;  ///< outside which it does not show
  /// A ray meets the face where its product with none of these is negative: homogeneous edge
  /// functions (Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates",
  /// 1997). So nothing has to be clipped at the eye. Two faces have the same function, to the bit,
  /// with opposite signs at a common edge: each ray meets one of them.
  std::array<Vec3, 3> edges;
  Vec3 nearness;        ///< a ray's product with it is 1 / depth, per metre
  std::uint32_t thing;  ///< see Mesh
  TextureId texture;
  // In repeats of the image, along the same axes:
  FaceGradient u;
  FaceGradient v;
  const MeshFace* face;
  SurfaceId mesh;
  bool isNarrow;  ///< it covers so few columns that groups of its spans are not worth their memory
};

/// Rows [rowBegin, rowEnd) of a lane that show a face.
struct FaceSpan {
  const FaceFront* front;
  std::size_t lane;
  int rowBegin;
  int rowEnd;
  double depth;  ///< metres; as in Span
};

}  // namespace hearth
