#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "light/bake_progress.h"
#include "light/baking/surface_light.h"
#include "light/baking/texel_sums.h"
#include "light/lightmap.h"

namespace hearth {

/// The sums to which the light of each source is added: one for all, or one for each.
using SumsOf = std::function<TexelSums&(std::size_t light)>;

/// Texels are baked in tiles, so that their samples take little memory.
std::vector<TexelRect> tilesOf(const TexelRect& texels);
/// Samples of a tile, side x side to each texel.
SampleBlocks samplesOf(const SurfaceLight& surface, const TexelRect& tile, int side);

/// Adds the light of some of the facing lights to the surface's texels; less of it after a request
/// to stop.
void addLights(SurfaceLight& surface, std::span<const std::size_t> lights,
               const BakeSettings& settings, const SumsOf& sumsOf, BakeProgress& progress,
               const std::stop_token& stop = {});

/// A quick preview of the same: one sample for kDraftSide x kDraftSide texels.
inline constexpr int kDraftSide = 4;
void addDraftOfLights(SurfaceLight& surface, std::span<const std::size_t> lights,
                      const BakeSettings& settings, const SumsOf& sumsOf);

/// The texels of a surface that must be baked to know some of them: these alone, or all where
/// texels share samples.
TexelRect bakedWith(const TexelRect& wanted, const LitSurface& surface,
                    const BakeSettings& settings);

/// The lightmap of a surface, or of the texels that must be baked; none if no light reaches
/// them.
std::optional<Lightmap> bakeSurface(SurfaceLight& surface, const TexelRect& baked,
                                    const BakeSettings& settings, BakeProgress& progress);

/// The lightmap of a surface from the sums of all its lights.
std::optional<Lightmap> lightmapOf(const TexelSums& sums, const BakeSettings& settings);

}  // namespace hearth
