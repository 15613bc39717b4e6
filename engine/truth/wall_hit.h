#pragma once

#include <variant>

#include "truth/ray.h"

namespace hearth {

/// A ray passes into the next sector, through its segment `twin`.
struct PortalCrossing {
  SectorId next;
  SegmentId twin;
};

/// What a ray meets when it leaves its sector through `segment` at `t`.
std::variant<TruthHit, PortalCrossing> meetWall(const Level& level, const Ray& ray,
                                                SegmentId segment, double t);

/// The sky has no place, only directions: turns to the right, and tangents of elevation.
/// `isBelow` for sky floors, which show the image upside down.
Vec2 skyImageMetres(Vec3 direction, const TextureMapping& sky, bool isBelow);

}  // namespace hearth
