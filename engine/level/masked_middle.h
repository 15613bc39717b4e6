#pragma once

#include "level/scene.h"

namespace hearth {

/// Whether a masked middle texture that shows is solid, and no hole, at a point of its plane
/// between its heights.
bool isSolidAt(const Scene& scene, SurfaceId maskedMiddle, Vec3 point);

}  // namespace hearth
