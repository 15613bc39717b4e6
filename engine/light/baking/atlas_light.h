#pragma once

#include <optional>
#include <span>

#include "light/lightmap.h"
#include "light/lit_mesh.h"

namespace hearth {

/// A patch of a mesh, or some of its small faces, and its light; none if it is dark.
struct PartOfAtlas {
  const LitMesh::Patch* patch;
  std::span<const LitMesh::SmallFace> faces;
  /// Of small faces, a row of three texels each: of their corners.
  std::optional<Lightmap> light;
};

/// The lightmap of a whole mesh, put together from those of its parts; none if all are dark.
std::optional<Lightmap> atlasOf(const LitMesh& mesh, std::span<const PartOfAtlas> parts);

}  // namespace hearth
