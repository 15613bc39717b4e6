#pragma once

#include <span>
#include <stop_token>

#include "light/baking/baked_surface.h"
#include "light/baking/left_out.h"

namespace hearth {

/// Adds the light of the used texels of a tile with as many rays as its shadows need: one ray to
/// each corner of a texel, which four texels share, and some more along each edge between a lit and
/// a dark corner. The polygon of a texel's lit part is then as exact as the shadow's edge is
/// straight. A texel that no shadow's edge crosses costs one ray for each light.
///
/// Adds what is empty of the tile to `empty`, if that is asked for. `Lit` is SurfaceLight or
/// PatchLight.
template <typename Lit>
void addClippedLight(Lit& surface, const UsedTexels& texels, const TexelRect& tile,
                     std::span<const std::size_t> lights, const SumsOf& sumsOf, EmptyTexels* empty,
                     const std::stop_token& stop);

/// Adds the used texels of a tile that are empty: all their corners are left out. `Places` is
/// SurfacePlaces or PatchPlaces.
template <typename Places>
void addEmptyOfCorners(const Places& places, const UsedTexels& texels, const TexelRect& tile,
                       EmptyTexels& empty);

}  // namespace hearth
