#pragma once

#include <span>
#include <stop_token>

#include "light/baking/baked_surface.h"

namespace hearth {

/// Adds the light of a surface with as many rays as its shadows need: one ray to each corner of a
/// texel, which four texels share, and some more along each edge between a lit and a dark corner.
/// The polygon of a texel's lit part is then as exact as the shadow's edge is straight. A texel
/// that no shadow's edge crosses costs one ray for each light.
///
/// `Lit` is SurfaceLight or PatchLight.
template <typename Lit>
void addClippedLight(Lit& surface, std::span<const std::size_t> lights, const SumsOf& sumsOf,
                     BakeProgress& progress, const std::stop_token& stop);

}  // namespace hearth
