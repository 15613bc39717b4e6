#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/float_box.h"
#include "level/mesh.h"
#include "math/box3.h"
#include "math/vec.h"

namespace hearth {

/// Some of the faces of a mesh, divided in two unless they are few.
struct FaceBranch {
  FloatBox box;         ///< around them
  std::uint32_t first;  ///< of them in FaceBranches::faces, or, if divided, of two branches
  std::uint32_t count;  ///< of them; 0 if divided
  std::uint8_t axis;    ///< along which the lower branch comes first; 0 is x

  bool isLeaf() const { return count > 0; }
};

/// The faces of a mesh, divided again and again where that costs rays least by the surface area
/// heuristic.
struct FaceBranches {
  static constexpr std::uint32_t kMaxFacesOfLeaf = 4;
  static constexpr std::size_t kMaxDepth = 64;

  Box3 box;                          ///< around all faces
  Vec3 middle;                       ///< of it; boxes of branches are relative to it
  std::vector<FaceBranch> branches;  ///< the first has all faces
  std::vector<std::uint32_t> faces;  ///< their indices, branch by branch
};

/// Of at least one face.
FaceBranches divideFaces(std::span<const MeshFace> faces);

}  // namespace hearth
