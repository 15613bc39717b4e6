#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "light/bake_progress.h"
#include "light/bakery.h"
#include "light/baking/left_out.h"
#include "light/baking/surface_light.h"
#include "light/baking/texel_sums.h"
#include "light/lightmap.h"

namespace hearth {

/// Returns the sums to which a light is added. All lights share one, or each has its own.
using SumsOf = std::function<TexelSums&(std::size_t light)>;

/// Divides texels into tiles. Each tile is baked by itself, so that its samples take little memory.
std::vector<TexelRect> tilesOf(const TexelRect& texels);
/// The samples of a tile: `side` x `side` in each texel. Here and below, `Lit` is SurfaceLight or
/// PatchLight.
template <typename Lit>
typename Lit::Blocks samplesOf(const Lit& surface, const TexelRect& tile, int side);

/// Adds some of the facing lights to the surface's texels. After a request to stop, some of their
/// light is missing.
void addLights(SurfaceLight& surface, std::span<const std::size_t> lights,
               const BakeSettings& settings, const SumsOf& sumsOf, BakeProgress& progress,
               const std::stop_token& stop = {});

/// For a quick preview, addLightsDraft() does the same with only one sample for each square of
/// kDraftSide x kDraftSide texels.
inline constexpr int kDraftSide = 4;
void addLightsDraft(SurfaceLight& surface, std::span<const std::size_t> lights,
                    const BakeSettings& settings, const SumsOf& sumsOf);

/// The texels of a surface that must be baked if only `wanted` are needed: these alone, or all if
/// texels share samples, or may take the light of others.
TexelRect texelsToBake(const SurfaceTexels& wanted, const Scene& scene, const LitSurfaces& surfaces,
                       const BakeSettings& settings);

/// Texels that take the light of others because none of their samples counts.
template <typename Lit>
EmptyTexels emptyTexelsOf(const Lit& surface, const TexelRect& baked, const BakeSettings& settings);

/// Bakes all texels of a surface, or those that must be baked. Returns their lightmap; none if no
/// light reaches them.
template <typename Lit>
std::optional<Lightmap> bakeSurface(Lit& surface, const TexelRect& baked,
                                    const BakeSettings& settings, BakeProgress& progress);

/// The lightmap of a surface from the sums of all its lights.
std::optional<Lightmap> lightmapOf(const TexelSums& sums, const BakeSettings& settings);

}  // namespace hearth
