#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "agreement/panel.h"

namespace hearth::agreement {

/// What of a mesh is lit as one surface: the faces of one plane that are larger than a texel and
/// joined by edges, or one smaller face, which is lit at its corners.
struct MeshPiece {
  std::size_t mesh;                  ///< index
  std::vector<std::uint32_t> faces;  ///< indices into Level::meshFaces
  bool isSmall;
  Panel panel;  ///< its axes begin where texels are counted from
};

/// The pieces of all meshes of a level, from the words of the guide to levels alone: every pair of
/// faces is tried.
class MeshPieces {
 public:
  /// Keeps the scene.
  explicit MeshPieces(const Scene& scene) : scene_(scene) {}

  /// By a face of the mesh. Of use for as long as this.
  const MeshPiece& pieceOf(std::uint32_t face);

  /// Whether a point is in the air of a sector that the mesh is in, or on its border.
  bool isInAir(std::size_t mesh, Vec3 point) const;

  /// Whether the line along the normal of a surface first meets a mesh's back: then its point, on
  /// the border of the air of `sector`, lies inside the mesh.
  bool isInsideMesh(Vec3 point, Vec3 normal, SectorId sector) const;

 private:
  std::vector<std::uint32_t> joinedWith(std::uint32_t face, std::size_t mesh) const;

  Scene scene_;
  std::map<std::uint32_t, std::size_t> pieceOfFace_;
  std::map<std::size_t, MeshPiece> pieces_;
};

}  // namespace hearth::agreement
