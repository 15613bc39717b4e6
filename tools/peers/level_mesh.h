#pragma once

#include <array>
#include <vector>

#include "level/scene.h"

namespace hearth {

struct MeshTriangle {
  std::array<Vec3, 3> corners;
  SurfaceId surface;
  Vec3 normal;  ///< into the air, not of unit length; the triangle is seen from there only
};

/// All surfaces of a level, skies included, as triangles: from its derived walls (which the truth
/// does not use), and flats cut into trapezoids. Models are not among them.
std::vector<MeshTriangle> meshOf(const Scene& scene);

/// The faces of a model that stands in the level.
std::vector<MeshTriangle> trianglesOf(const Scene& scene, const Mesh& model);

/// What stops light: surfaces, except skies and middle textures, which have holes; and models that
/// cast shadows.
std::vector<MeshTriangle> meshInLight(const Scene& scene);

/// The outline of a sector as triangles on the map.
std::vector<std::array<Vec2, 3>> trianglesOf(const Level& level, const Sector& sector);

}  // namespace hearth
