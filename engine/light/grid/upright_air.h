#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "level/scene.h"

namespace hearth {

/// A polygon in the plane of a segment, as (fraction of the way from its p0 to its p1, z in
/// metres).
using UprightOutline = std::vector<Vec2>;

/// The part of an upright surface that bounds air: the part that the slopes on both sides leave.
/// The surface shows. Convex; fewer than three points if the slopes leave nothing.
UprightOutline uprightAir(const Scene& scene, SurfaceId id);

/// The ends of the edge that two convex outlines have in common, if it has a length. The outlines
/// do not overlap. Both are of one segment, or of two with the same ends, `segmentLength` metres
/// long.
std::optional<std::pair<Vec2, Vec2>> commonEdge(const UprightOutline& a, const UprightOutline& b,
                                                double segmentLength);

/// The heights, low and high, that a convex outline covers at one end of its segment (fraction 0 or
/// 1), `segmentLength` metres long; low > high if it does not reach that end.
std::pair<double, double> heightsAt(const UprightOutline& air, double fraction,
                                    double segmentLength);

}  // namespace hearth
