#pragma once

#include <optional>

#include "light/bake_progress.h"
#include "light/lightmap.h"
#include "light/surface_light.h"

namespace hearth {

/// The lightmap of a surface; none where no light reaches it.
std::optional<Lightmap> bakeSurface(SurfaceLight& surface, const BakeSettings& settings,
                                    BakeProgress& progress);

}  // namespace hearth
