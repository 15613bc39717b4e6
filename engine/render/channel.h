#pragma once

namespace hearth {

/// Views of the renderer's own numbers, for tests and for eyes. Holes of masked middle textures
/// and sprites show the surfaces behind them. These and meshes do not count as drawn.
enum class Channel {
  Sector,    ///< a colour per sector
  Surface,   ///< a colour per surface
  Faces,     ///< a colour per face of a mesh; all else as Surface has it, dark
  Depth,     ///< 255 at the eye, 128 at 1 m depth, falling as 1 / (1 + depth)
  Uv,        ///< red and green: u and v within the repeat
  Normal,    ///< (normal + 1) / 2 as x, y, z; of faces out of their front, whichever side shows
  Backs,     ///< faces of meshes seen from their backs red, all else grey
  Light,     ///< the lightmap alone, without sector light
  Overdraw,  ///< green where a pixel is drawn once, red where more often
};

/// What can be marked on the lit picture.
enum class Marks {
  Texels,    ///< lines between the lightmap's texels; where these are small, between every 8th
  Outlines,  ///< edges of walls white, of openings orange, of flat portals and in stacks green
  Coverage,  ///< magenta where nothing is drawn, red where more than once; all else dimmed
  Vertices,  ///< yellow dots at the corners of faces of meshes, where such a face shows
};

}  // namespace hearth
