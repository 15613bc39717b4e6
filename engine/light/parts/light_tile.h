#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/bake_settings.h"
#include "level/scene.h"
#include "light/baking/light_visibility.h"
#include "light/lit_mesh.h"
#include "light/lit_surface.h"

namespace hearth {

/// A piece of a bake that needs no other one.
struct LightTile {
  enum class Kind { Surface, Patch, SmallFaces, Sprite };

  Kind kind;
  std::uint32_t index;  ///< of the surface, the mesh or the sprite
  std::uint32_t piece;  ///< of a mesh: one of its patches, or of its smallFacesAtOnce()
  TexelRect texels;     ///< of the surface or patch; of small faces, a row for each
  double cost = 0;      ///< what it is expected to take, in nanoseconds

  bool isOfMesh() const { return kind == Kind::Patch || kind == Kind::SmallFaces; }
  /// Whether both are tiles of one lightmap, or of one part of an atlas.
  bool isOfSameMap(const LightTile& other) const {
    return kind == other.kind && index == other.index && piece == other.piece;
  }
};

/// A level as it is lit.
struct LevelInTiles {
  LevelInTiles(const Scene& scene, const BakeSettings& settings, int threads);

  LitSurfaces surfaces;
  std::vector<LitMesh> meshes;
  LightVisibilities visibilities;
  /// In the order in which they are dealt out and written. Surfaces that no light can shine on have
  /// none.
  std::vector<LightTile> tiles;
};

/// Deals tiles to so many parts: the index of the first one of each, and at last their number. The
/// tiles of a part follow one another, so they mostly see the same lights, and few parts need the
/// beam tree of a light. The costs of the parts are as nearly the same as tiles allow.
std::vector<std::size_t> firstTilesOf(std::uint32_t parts, const std::vector<LightTile>& tiles);

}  // namespace hearth
