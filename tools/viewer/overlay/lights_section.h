#pragma once

#include "level/scene.h"
#include "render/camera.h"
#include "viewer/overlay/lights_tool.h"

namespace hearth {

/// A section of the overlay: the lights of a level, to be edited. Without a tool, why not. New ones
/// come before the camera.
void showLights(LightsTool* tool, const Scene& scene, const Camera& camera);

}  // namespace hearth
