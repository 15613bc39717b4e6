#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "level/ids.h"
#include "level/segment.h"
#include "light/rays/ray_walls.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "math/vec.h"

namespace hearth {

/// Where a ray leaves a sector over its outline.
struct Exit {
  const Segment* segment;
  double t;
};

/// A ray on the map, and how it crosses the outlines of sectors.
class PlanLine {
 public:
  /// `length2`: square of the length in space of t = 1.
  PlanLine(Vec2 origin, Vec2 delta, double length2, double tEnd)
      : origin_(origin),
        delta_(delta),
        planLength2_(dot(delta, delta)),
        length2_(length2),
        tEnd_(tEnd) {}

  double tEnd() const { return tEnd_; }
  Vec2 at(double t) const { return origin_ + t * delta_; }

  /// Signed distance (scaled) of a vertex to the right of the ray; the same bits for all segments
  /// that share the vertex, so that no ray slips between two of them.
  double sideOf(Vec2 p) const { return cross(delta_, p - origin_); }

  /// Where it crosses a segment, with ends on both of its sides.
  double crossingOf(const Segment& segment) const {
    return crossingOf(segment, sideOf(segment.p0), sideOf(segment.p1));
  }

  /// The first of a sector's segments that is seen from its front beyond where the ray came into
  /// the sector: at `tIn`, through its segment `entry`, if through one.
  template <typename Walls>
  Exit exitOf(const Walls& walls, SectorId sector, double tIn, const Segment* entry) const {
    Exit best{nullptr, std::numeric_limits<double>::infinity()};
    if (planLength2_ == 0) return best;
    const auto meet = [&](const Segment& segment) {
      const double side0 = sideOf(segment.p0);
      const double side1 = sideOf(segment.p1);
      if (side0 >= 0 || side1 < 0) return;
      const double t = crossingOf(segment, side0, side1);
      if (t > best.t + kNearTie * best.t || !isBeyond(segment, t, tIn, entry)) return;
      if (t >= best.t - kNearTie * best.t && best.segment &&
          !meetsFirst(origin_, segment.p0, segment.p1, best.segment->p0, best.segment->p1))
        return;
      best = {&segment, t};
    };
    walls.visit(sector, PlanRay{origin_, delta_, tIn, length2_, tEnd_}, meet,
                [&] { return best.t; });
    return best;
  }

  /// Whether the ray leaves an outline once more often than it comes in, beyond t.
  bool isInside(std::span<const Segment> outline, double t) const {
    int leaves = 0;
    for (const Segment& segment : outline) {
      const double side0 = sideOf(segment.p0);
      const double side1 = sideOf(segment.p1);
      if ((side0 >= 0) == (side1 >= 0) || crossingOf(segment, side0, side1) <= t) continue;
      leaves += side0 < 0 ? 1 : -1;
    }
    return leaves == 1;
  }

 private:
  double crossingOf(const Segment& segment, double side0, double side1) const {
    // In a fixed order of the end points, so that a segment and its twin agree to the bit.
    const bool swap = lessXY(segment.p1, segment.p0);
    const Vec2 a = swap ? segment.p1 : segment.p0;
    const Vec2 b = swap ? segment.p0 : segment.p1;
    const double sideA = swap ? side1 : side0;
    const double sideB = swap ? side0 : side1;
    return dot(lerp(a, b, sideA / (sideA - sideB)) - origin_, delta_) / planLength2_;
  }

  bool isBeyond(const Segment& segment, double t, double tIn, const Segment* entry) const {
    const double tiny = kNearTie * std::max(tIn, kNearTie);
    if (t > tIn + tiny) return true;
    if (t < tIn - tiny) return false;
    return !entry || meetsFirst(origin_, entry->p0, entry->p1, segment.p0, segment.p1);
  }

  Vec2 origin_;
  Vec2 delta_;
  double planLength2_;
  double length2_;
  double tEnd_;
};

}  // namespace hearth
