#pragma once

#include "image/pixel_rows.h"
#include "level/scene.h"
#include "render/camera.h"

namespace hearth {

/// Draws View::Wireframe, on black. `projection` is the camera's.
void drawWireframe(const Scene& scene, const Camera& camera, const Projection& projection,
                   const PixelRows& picture);

}  // namespace hearth
