#pragma once

#include "viewer/overlay/lights_tool.h"
#include "viewer/overlay/marker_space.h"

namespace hearth {

/// While a light is dragged, draws into the picture, beneath the panel: the axes of the level
/// beside the light's mark, or the one along which it is dragged, and its position. Expects a frame
/// of ImGui.
void drawDragAxes(const LightsTool& tool, const MarkerSpace& space, int pictureHeight);

}  // namespace hearth
