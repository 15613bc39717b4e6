#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "level/ids.h"
#include "math/vec.h"

namespace hearth {

/// A triangle of a mesh, where it is in the level.
struct MeshFace {
  std::array<Vec3, 3> corners;  ///< counter-clockwise as seen from its front
  std::array<Vec2, 3> image;    ///< at the corners, in repeats of the image to the right and down
  TextureId texture;
};

/// Out of a face's front. As long as twice its area in square metres.
inline Vec3 frontOf(const MeshFace& face) {
  // The axes of a level are left-handed: x to the right of the map, y down it, z up.
  return cross(face.corners[2] - face.corners[0], face.corners[1] - face.corners[0]);
}

/// A model that stands in the air of a level.
struct Mesh {
  std::string name;            ///< may be empty
  Vec3 position;               ///< of the model's origin
  SectorId sector;             ///< that contains `position`
  bool isTwoSided = false;     ///< its faces are seen from their backs, too
  bool isSolid = true;         ///< to the player
  bool castsShadow = true;     ///< it stops light
  bool standsOnFloor = false;  ///< of its sector, with which it moves
  std::uint32_t thing = 0;     ///< index among the level's sprites and meshes together

  // Its faces are [firstFace, firstFace + faceCount) of Level::meshFaces.
  std::uint32_t firstFace = 0;
  std::uint32_t faceCount = 0;

  SurfaceId surface;  ///< set by `addThingSurfaces`
};

}  // namespace hearth
