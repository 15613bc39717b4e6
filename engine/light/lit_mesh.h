#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "level/level.h"
#include "light/lit_surface.h"

namespace hearth {

/// A mesh as the bakery and the renderer's light see it. One lightmap, an atlas, has the light of
/// all its faces.
struct LitMesh {
  SurfaceId surface;
  TexelRect texels;  ///< of the lightmap
  /// Where the corners of each face lie on the lightmap, in its texel coordinates; between them
  /// places change evenly.
  std::vector<std::array<Vec2, 3>> places;

  /// Faces in one plane that are larger than a texel, on a texel grid of their own.
  struct Patch {
    std::vector<std::uint32_t> faces;  ///< indices into the mesh's faces
    LitSurface surface;
    int i;  ///< texel (i, j) of the lightmap is the first of `surface.texels`
    int j;
  };
  std::vector<Patch> patches;

  /// A face without a grid: light is found at its corners, which are the middles of texels (i, j),
  /// (i + 1, j) and (i, j + 1). Light in between changes evenly, so texel (i + 1, j + 1) continues
  /// it.
  struct SmallFace {
    std::uint32_t face;  ///< index into the mesh's faces
    int i;
    int j;
  };
  std::vector<SmallFace> smallFaces;
};

/// Where a point of a face, by its index into the mesh's faces, lies on the mesh's lightmap.
Vec2 placeOn(const LitMesh& mesh, std::uint32_t index, const MeshFace& face, Vec3 point);

/// The side of the square of texels that a small face has.
inline constexpr int kSmallFaceSide = 2;
std::int64_t texelsOfSmallFaces(std::span<const LitMesh::SmallFace> faces);

/// The small faces of a mesh, as many at once as are lit together.
std::vector<std::span<const LitMesh::SmallFace>> smallFacesAtOnce(const LitMesh& mesh);

/// Of a mesh by its index. `texel` in metres, > 0.
LitMesh makeLitMesh(const Level& level, std::uint32_t mesh, double texel);

/// The same of all meshes of a level, in their order, or of some of them: the others stay empty.
std::vector<LitMesh> makeLitMeshes(const Level& level, double texel, int threads);
std::vector<LitMesh> makeLitMeshes(const Level& level, double texel,
                                   std::span<const std::uint32_t> meshes, int threads);

/// Leaves only the patches and small faces that some faces are part of. `faces` are indices into
/// the level's, by rising index. Light stays where it lies on the lightmap.
void keepOnly(std::span<const std::uint32_t> faces, const Mesh& of, LitMesh& mesh);

}  // namespace hearth
