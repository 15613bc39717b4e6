#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "light/bake_progress.h"
#include "light/bakery.h"
#include "light/baking/lightmap_builder.h"
#include "light/baking/surface_light.h"
#include "light/baking/texel_sums.h"
#include "light/lightmap.h"
#include "light/used_texels.h"

namespace hearth {

/// Returns the sums to which a light is added. All lights share one, or each has its own.
using SumsOf = std::function<TexelSums&(std::size_t light)>;

/// Divides texels into tiles of at most `side` x `side`.
std::vector<TexelRect> tilesOf(const TexelRect& texels, int side);
/// Divides what is used of them into tiles that are baked one by one, so small that the samples of
/// one stay in the processor's cache.
std::vector<TexelRect> tilesOf(const UsedTexels& texels);
/// The samples of a tile: `side` x `side` in each texel, spare ones in texels that are not used.
/// Here and below, `Lit` is SurfaceLight or PatchLight.
template <typename Lit>
typename Lit::Blocks samplesOf(const Lit& surface, const UsedTexels& texels, const TexelRect& tile,
                               int side);

/// Adds some of the facing lights to used texels of the surface. After a request to stop, some of
/// their light is missing.
void addLights(SurfaceLight& surface, const UsedTexels& texels, std::span<const std::size_t> lights,
               const BakeSettings& settings, const SumsOf& sumsOf, BakeProgress& progress,
               const std::stop_token& stop = {});

/// For a quick preview, addLightsDraft() does the same with only one sample for each square of
/// kDraftSide x kDraftSide texels.
inline constexpr int kDraftSide = 4;
void addLightsDraft(SurfaceLight& surface, std::span<const std::size_t> lights,
                    const BakeSettings& settings, const SumsOf& sumsOf);

/// The texels of a surface that must be baked if only `wanted` are needed: these alone, or all if
/// texels may take the light of others.
TexelRect texelsToBake(const SurfaceTexels& wanted, const Scene& scene,
                       const LitSurfaces& surfaces);

/// Bakes all texels of a surface, or those that must be baked. Returns their lightmap; none if no
/// light reaches them.
template <typename Lit>
std::optional<Lightmap> bakeSurface(Lit& surface, const TexelRect& rect,
                                    const BakeSettings& settings, BakeProgress& progress);

/// The sums of all facing lights in a tile of the surface's texels. After a request to stop, some
/// of their light is missing.
template <typename Lit>
TexelSums sumsOfTile(Lit& surface, const TexelRect& tile, const BakeSettings& settings,
                     const std::stop_token& stop = {});

/// Used texels that take the light of others because none of their samples counts. `Places` here
/// and below is SurfacePlaces or PatchPlaces.
template <typename Places>
EmptyTexels emptyTexelsOf(const Places& places, const UsedTexels& texels,
                          const BakeSettings& settings);

/// The lightmap of a surface to which the sums of all lights in all texels are added.
template <typename Places>
std::optional<Lightmap> finishedLightmap(const Places& places, LightmapBuilder map,
                                         const BakeSettings& settings);

}  // namespace hearth
