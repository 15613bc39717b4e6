#pragma once

#include "viewer/overlay/lights_tool.h"
#include "viewer/overlay/marker_space.h"

namespace hearth {

/// While a light is dragged, draws the axes of the level beside its mark, or the one along which it
/// is dragged, and where it is: into the picture, beneath the panel. Expects a frame of ImGui.
void drawDragAxes(const LightsTool& tool, const MarkerSpace& space, int pictureHeight);

}  // namespace hearth
