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
/// does not use), and flats cut into trapezoids.
std::vector<MeshTriangle> meshOf(const Scene& scene);

/// Of these, what stops light: no skies, nor what hangs in openings and has holes.
std::vector<MeshTriangle> meshInLight(const Scene& scene);

/// The outline of a sector as triangles on the map.
std::vector<std::array<Vec2, 3>> trianglesOf(const Level& level, const Sector& sector);

}  // namespace hearth
