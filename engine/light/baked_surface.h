#pragma once

#include <optional>

#include "light/bake_progress.h"
#include "light/lightmap.h"
#include "light/surface_light.h"

namespace hearth {

/// The lightmap of a surface; none where no light reaches it. `samples` to a texel, a square
/// number, or none for as many as shadows' edges need.
std::optional<Lightmap> bakeSurface(SurfaceLight& surface, std::optional<int> samples,
                                    BakeProgress& progress);

}  // namespace hearth
