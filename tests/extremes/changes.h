#pragma once

#include <functional>

#include "level_files.h"
#include "math/vec.h"

/// Changes of a level after which it must look the same.
namespace hearth::extremes {

/// How lengths of a level change.
struct LengthChange {
  std::function<Vec2(Vec2)> point;       ///< of the map
  std::function<double(double)> height;  ///< absolute
  std::function<double(double)> length;  ///< along a wall
};

/// With other vertices, heights, places of textures on walls, and positions. Leaves the sizes of
/// textures, lights, texels and the player's body as they are.
LevelFiles withLengths(const LevelFiles& files, const LengthChange& change);

/// Moved; images on flats move with their sector, by whatever distance.
LevelFiles moved(const LevelFiles& files, Vec3 by);

/// All lengths multiplied: texels, images and lights too.
LevelFiles scaled(const LevelFiles& files, double factor);

/// Turned about the origin, `degrees` from x to y.
LevelFiles turned(const LevelFiles& files, double degrees);

/// With x and -x exchanged. Walls keep their order along the loop, and their first vertex.
LevelFiles mirrored(const LevelFiles& files);

/// Every wall in two, at its middle. `along` of the second half goes on.
LevelFiles withWallsCut(const LevelFiles& files);

/// Every sector under a name that no file had before, in another alphabetical order.
LevelFiles renamed(const LevelFiles& files);

/// Sectors and lights the other way round.
LevelFiles reordered(const LevelFiles& files);

/// Every flat and slope in a colour of its own instead of its image, skies too: images on flats lie
/// along x and y, and do not turn with the level.
LevelFiles withPlainFlats(const LevelFiles& files);

/// Every sidewall in a colour of its own: its image begins at the end of the wall that it stands
/// on, wherever that wall is cut.
LevelFiles withPlainSidewalls(const LevelFiles& files);

/// Every texture a colour of its own.
LevelFiles withPlainColors(const LevelFiles& files);

/// Without things: images of sprites have sizes of their own, and nothing that things show has a
/// mirror.
LevelFiles withoutThings(const LevelFiles& files);

/// With a sealed sector far away from everything, that has all that costs something where it is
/// used: a slope, stacks, coloured balls of light with curves.
LevelFiles withUnseenSector(const LevelFiles& files);

}  // namespace hearth::extremes
