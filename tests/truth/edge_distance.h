#pragma once

#include "peers/level_mesh.h"

namespace hearth {

/// Metres from the straight line between two points to the nearest edge of the triangle.
double distanceToEdge(const MeshTriangle& triangle, Vec3 from, Vec3 to);

}  // namespace hearth
