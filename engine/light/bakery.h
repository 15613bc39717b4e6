#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "level/bake_settings.h"
#include "level/scene.h"
#include "light/bake_progress.h"
#include "light/light_cost.h"
#include "light/lightmap.h"
#include "light/lit_mesh.h"
#include "light/lit_surface.h"

namespace hearth {

struct BakeStats {
  std::size_t surfaces = 0;         ///< that could be lit
  std::size_t litSurfaces = 0;      ///< that some light reaches: those that have a lightmap
  std::size_t coloredSurfaces = 0;  ///< of those, the ones with three channels
  std::int64_t texels = 0;          ///< of the surfaces that could be lit
  std::int64_t rays = 0;            ///< that were traced
  std::int64_t bytes = 0;           ///< of all lightmaps, as they are kept
};

/// What a bake did for one surface.
struct SurfaceCost {
  std::size_t facingLights = 0;  ///< in front of its plane and within reach of it
  std::int64_t rays = 0;
};

/// The baked light of a level. Surfaces that no light reaches have no lightmap.
struct BakedLight {
  LitSurfaces surfaces;                            ///< by SurfaceId
  std::vector<LitMesh> meshes;                     ///< in the order of the level's
  std::vector<std::optional<Lightmap>> lightmaps;  ///< by SurfaceId
  BakeStats stats;
  std::vector<SurfaceCost> surfaceCosts;  ///< by SurfaceId
  std::vector<LightCost> lightCosts;      ///< in the order of the level's lights; then those of
                                          ///< light that bounces
};

/// Counts the stats of lightmaps. The rays are those of `surfaceCosts`, and 0 without them.
BakeStats statsOf(const BakedLight& baked);

/// Why the level cannot be baked with these settings, beginning with the setting (`texel: ...`);
/// none if it can.
std::optional<std::string> mistakeInSettings(const Scene& scene, const BakeSettings& settings);

/// Lights every surface that shows. `settings` must pass mistakeInSettings(). The bytes do not
/// depend on `threads`. `progress`, if any, must be new; it is complete on return.
BakedLight bake(const Scene& scene, const BakeSettings& settings, int threads,
                BakeProgress* progress = nullptr);

/// Texels of a surface, at least one.
struct SurfaceTexels {
  SurfaceId surface;
  TexelRect texels;
};

/// Texels of a part of a level.
struct WantedTexels {
  std::vector<SurfaceTexels> surfaces;  ///< each is listed once
  std::vector<std::uint32_t> faces;     ///< of meshes: indices into Level::meshFaces, rising
};

/// Bakes only these texels, and sprites. They get the same light as in a whole bake. `surfaces` are
/// the scene's, on grids of `settings`. Texels that were not wanted are black, or their surface has
/// no lightmap.
BakedLight bakeOnly(const WantedTexels& wanted, LitSurfaces surfaces, const Scene& scene,
                    const BakeSettings& settings, int threads, BakeProgress* progress = nullptr);

}  // namespace hearth
