#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/bake_settings.h"
#include "level/scene.h"
#include "light/baking/light_reach.h"
#include "light/lit_mesh.h"
#include "light/lit_surface.h"

namespace hearth {

/// One lightmap, or one piece of a mesh's atlas.
struct LightMapId {
  enum class Kind { Surface, Patch, SmallFaces, Sprite };

  Kind kind;
  std::uint32_t index;  ///< of the surface, the mesh or the sprite
  std::uint32_t piece;  ///< of a mesh: one of its patches, or of its smallFacesAtOnce()

  bool isOfMesh() const { return kind == Kind::Patch || kind == Kind::SmallFaces; }
  bool isOfOneTile() const { return kind == Kind::SmallFaces || kind == Kind::Sprite; }

  friend auto operator<=>(const LightMapId&, const LightMapId&) = default;
};

/// A piece of a bake that needs no other one.
struct LightTile {
  LightMapId map;
  TexelRect texels;  ///< of the surface or patch; of small faces, a row for each
  double cost = 0;   ///< what it is expected to take, in nanoseconds
};

/// A level as it is lit.
struct LevelInTiles {
  LevelInTiles(const Scene& scene, const BakeSettings& settings, int threads);

  LitSurfaces surfaces;
  std::vector<LitMesh> meshes;
  LightReach reach;
  /// In the order in which they are dealt out and written. Surfaces that no light can shine on have
  /// none.
  std::vector<LightTile> tiles;
};

/// Deals tiles to so many parts: the index of the first one of each, and at last their number. The
/// tiles of a part follow one another, so they are near one another, and few parts need the beam
/// tree of a light. The costs of the parts are as nearly the same as tiles allow.
std::vector<std::size_t> firstTilesOf(std::uint32_t parts, const std::vector<LightTile>& tiles);

}  // namespace hearth
