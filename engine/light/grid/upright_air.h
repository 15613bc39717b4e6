#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "level/scene.h"

namespace hearth {

/// A polygon in the plane of a segment, as (fraction of the way from its p0 to its p1, z in
/// metres).
using UprightOutline = std::vector<Vec2>;

/// The part of an upright surface, one that shows, that bounds air: what the slopes on both sides
/// leave of it. Convex; fewer than three points where they leave nothing.
UprightOutline uprightAir(const Scene& scene, SurfaceId id);

/// The ends of what two convex outlines that do not overlap have in common, if that has a length.
/// Both are of one segment, or of two with the same ends, `segmentLength` metres long.
std::optional<std::pair<Vec2, Vec2>> commonEdge(const UprightOutline& a, const UprightOutline& b,
                                                double segmentLength);

/// The heights, low and high, that a convex outline covers at one end of its segment (fraction 0 or
/// 1), `segmentLength` metres long; low > high where it does not reach that end.
std::pair<double, double> heightsAt(const UprightOutline& air, double fraction,
                                    double segmentLength);

}  // namespace hearth
