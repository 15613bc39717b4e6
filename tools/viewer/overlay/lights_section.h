#pragma once

#include "level/scene.h"
#include "render/camera.h"
#include "viewer/overlay/lights_tool.h"

namespace hearth {

/// A section of the overlay: the lights of a level, to be edited. If `tool` is null, says why
/// lights cannot be edited. A new light is put in front of the camera.
void showLights(LightsTool* tool, const Scene& scene, const Camera& camera);

}  // namespace hearth
