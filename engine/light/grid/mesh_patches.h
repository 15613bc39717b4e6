#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "level/mesh.h"
#include "light/lit_surface.h"

namespace hearth {

/// Faces of a mesh that lie in one plane and share edges: a surface that is merely cut.
struct MeshPatch {
  std::vector<std::uint32_t> faces;  ///< indices into the mesh's faces
  LitSurface surface;                ///< without continuations
};

/// The faces of a mesh, divided by how light lies on them.
struct DividedMesh {
  std::vector<MeshPatch> patches;         ///< of faces that are larger than a texel
  std::vector<std::uint32_t> smallFaces;  ///< no larger than a texel along both axes of their grid
};

/// Grids of texels, in metres, lie in the planes of patches: with axes along the contour line and
/// the steepest ascent, or x and y in what is level. Texels are counted from the least place of the
/// patch along the axes, in upright planes from z = 0, in level ones from the level's origin. A
/// patch has no more than 256 faces.
DividedMesh dividedMesh(std::span<const MeshFace> faces, double texel);

}  // namespace hearth
