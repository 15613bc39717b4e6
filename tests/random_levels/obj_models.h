#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "math/vec.h"

namespace hearth::random_levels {

/// What the faces of a model wear.
enum class ObjSkin {
  Colors,   ///< materials of plain colours
  Images,   ///< materials of images, and one of a plain colour
  OfThing,  ///< no material: the texture that a level names for it
};

/// A Wavefront OBJ file that random levels name.
struct ObjModel {
  std::string name;  ///< of its file, without the extension
  ObjSkin skin;
  bool isClosed = false;                           ///< the boundary of a solid
  std::vector<Vec3> vertices;                      ///< m; x, y up, z; right-handed
  std::vector<std::vector<std::size_t>> polygons;  ///< counter-clockwise seen from the front
};

/// All of them, always the same, about 1 m across.
std::vector<ObjModel> objModels();

/// Numbers of two of them: of a square that lies and faces up, and of one that stands upright and
/// faces along +x.
inline constexpr std::size_t kObjTile = 0;
inline constexpr std::size_t kObjPanel = 1;

/// Text of `<name>.obj`.
std::string objText(const ObjModel& model);
/// Text of `<name>.mtl`, whose images are those of random levels; empty without materials.
std::string mtlText(const ObjModel& model);

}  // namespace hearth::random_levels
