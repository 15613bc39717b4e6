#pragma once

#include <vector>

#include "light/bakery.h"
#include "render/camera.h"
#include "render/draw_settings.h"

namespace hearth {

/// The texels that a frame can read of lightmaps, by rising surface: for each surface in view a
/// rectangle of them. `surfaces` are the level's.
std::vector<SurfaceTexels> texelsInView(const Scene& scene, const LitSurfaces& surfaces,
                                        const Camera& camera, const DrawSettings& settings);

}  // namespace hearth
