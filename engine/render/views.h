#pragma once

#include <cstdint>

#include "image/pixel_rows.h"
#include "level/scene.h"
#include "render/camera.h"

namespace hearth {

/// Pictures of the four spaces through which a wall passes on its way to the screen, and a
/// wireframe of the last one. Walls without an opening are white, walls with one orange; on the
/// screen the edges of flat portals are green. The wireframe alone has meshes, in blue.
enum class View : std::uint8_t {
  World,       ///< the plan, y down, with the eye and its field of view
  Camera,      ///< as the camera turns it: the eye below, looking up; dim outside its view
  DepthSpace,  ///< columns to the right, 1/depth downwards: the segments in view, still straight
  Screen,      ///< edges of the walls in view, dim where something hides them
  Wireframe,   ///< edges of all walls and of the faces of meshes in the field of view, hidden or
               ///< not, dimmer when far
};

/// Draws a picture, which has the camera's size. The camera's sector contains its eye. Distant or
/// huge geometry is clipped; lines past the range of double are left out.
void drawView(const Scene& scene, const Camera& camera, View view, const PixelRows& picture);
/// A single picture, for a file.
Image drawView(const Scene& scene, const Camera& camera, View view);

}  // namespace hearth
