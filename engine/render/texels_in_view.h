#pragma once

#include "light/bakery.h"
#include "render/camera.h"
#include "render/draw_settings.h"

namespace hearth {

/// The texels of lightmaps that a frame can read: a rectangle for each surface in view, by rising
/// SurfaceId, and the faces of meshes. `surfaces` are the level's.
WantedTexels texelsInView(const Scene& scene, const LitSurfaces& surfaces, const Camera& camera,
                          const DrawSettings& settings);

}  // namespace hearth
