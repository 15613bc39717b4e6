#pragma once

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
#include "light/lit_surface.h"

namespace hearth {

struct BakeStats {
  std::size_t surfaces = 0;         ///< that could be lit
  std::size_t litSurfaces = 0;      ///< that some light reaches: those that have a lightmap
  std::size_t coloredSurfaces = 0;  ///< of those, the ones with three channels
  std::int64_t texels = 0;          ///< computed
  std::int64_t rays = 0;            ///< that were traced
  std::int64_t bytes = 0;           ///< of all lightmaps, as they are kept
};

/// What a bake did for one surface.
struct SurfaceCost {
  std::size_t facingLights = 0;  ///< that lie before its plane, and reach as far
  std::int64_t rays = 0;
};

/// The baked light of a level. Surfaces that no light reaches have no lightmap.
struct BakedLight {
  LitSurfaces surfaces;                            ///< by SurfaceId
  std::vector<std::optional<Lightmap>> lightmaps;  ///< by SurfaceId
  BakeStats stats;
  std::vector<SurfaceCost> surfaceCosts;  ///< by SurfaceId
  std::vector<LightCost> lightCosts;      ///< in the order of the level's lights
};

/// What the lightmaps show of how they came about: all but the rays.
BakeStats statsOf(const BakedLight& baked);

/// Why the level cannot be baked so, beginning with the setting (`texel: ...`), or nothing.
std::optional<std::string> mistakeInSettings(const Scene& scene, const BakeSettings& settings);

/// Lights every surface that shows, with settings without a mistake. The bytes do not depend on
/// `threads`. `progress`, if any, is new, and has all texels done when the bake is.
BakedLight bake(const Scene& scene, const BakeSettings& settings, int threads,
                BakeProgress* progress = nullptr);

/// Texels of a surface, of which there is at least one.
struct SurfaceTexels {
  SurfaceId surface;
  TexelRect texels;
};

/// Bakes texels of some surfaces alone, each surface named once: they get what a whole bake gives
/// them. `surfaces` are the scene's, on grids of `settings`. All other texels are dark, or in no
/// lightmap.
BakedLight bakeOnly(std::span<const SurfaceTexels> wanted, LitSurfaces surfaces, const Scene& scene,
                    const BakeSettings& settings, int threads, BakeProgress* progress = nullptr);

}  // namespace hearth
