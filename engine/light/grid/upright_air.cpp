#include "light/grid/upright_air.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// z over a segment: one height at p0 and one at p1.
struct Line {
  double at0;
  double at1;
};

/// The part of a convex polygon in (fraction, z) that lies above the line (below it for `sign` -1).
UprightOutline clipped(UprightOutline polygon, Line line, double sign) {
  const auto height = [&](Vec2 p) { return sign * (p.y - std::lerp(line.at0, line.at1, p.x)); };
  if (std::ranges::all_of(polygon, [&](Vec2 p) { return height(p) >= 0; })) return polygon;
  UprightOutline kept;
  kept.reserve(polygon.size() + 1);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    const double ha = height(a);
    const double hb = height(b);
    if (ha >= 0) kept.push_back(a);
    if ((ha > 0 && hb < 0) || (ha < 0 && hb > 0)) kept.push_back(lerp(a, b, ha / (ha - hb)));
  }
  return kept;
}

}  // namespace

// Convex, because what limits it from below is a maximum of lines and from above a minimum.
UprightOutline uprightAir(const Scene& scene, SurfaceId id) {
  const Surface& surface = scene[id];
  const Segment& segment = scene[*surface.segment];
  const SegmentGeometry& near = scene.geometryOf(segment);
  const double zBottom = scene.geometryOf(id).zBottom;
  const double zTop = scene.geometryOf(id).zTop;
  UprightOutline air = {{0, zBottom}, {1, zBottom}, {1, zTop}, {0, zTop}};
  air = clipped(std::move(air), {near.air0.zBottom, near.air1.zBottom}, 1);
  air = clipped(std::move(air), {near.air0.zTop, near.air1.zTop}, -1);
  if (!isSidewall(surface.kind)) return air;
  for (const WallPiece& piece : scene.piecesOf(segment)) {
    const Opening* opening = std::get_if<Opening>(&piece.content);
    if (!opening || piece.zBottom != zBottom) continue;
    const SegmentGeometry& far = scene.geometryOf(scene[opening->twin]);
    if (surface.kind == SurfaceKind::FloorSidewall)
      return clipped(std::move(air), {far.air1.zBottom, far.air0.zBottom}, -1);
    // Wedges may pass each other by an author's noise. Then the lower one shows, as in openingSpan.
    air = clipped(std::move(air), {far.air1.zBottom, far.air0.zBottom}, 1);
    return clipped(std::move(air), {far.air1.zTop, far.air0.zTop}, 1);
  }
  return air;
}

std::optional<std::pair<Vec2, Vec2>> commonEdge(const UprightOutline& a, const UprightOutline& b,
                                                double segmentLength) {
  const auto metres = [&](Vec2 p) { return Vec2{p.x * segmentLength, p.y}; };
  UprightOutline common;
  const auto gather = [&](const UprightOutline& from, const UprightOutline& to) {
    for (const Vec2 p : from)
      for (std::size_t i = 0; i < to.size(); ++i) {
        const Vec2 end0 = metres(to[i]);
        const Vec2 end1 = metres(to[(i + 1) % to.size()]);
        if (length(nearestOnSegment(end0, end1, metres(p)) - metres(p)) <= kHeightNoise)
          common.push_back(p);
      }
  };
  gather(a, b);
  gather(b, a);
  if (common.empty()) return std::nullopt;
  const auto [low, high] = std::ranges::minmax_element(common, lessXY);
  if (length(metres(*high) - metres(*low)) <= kHeightNoise) return std::nullopt;
  return std::pair(*low, *high);
}

std::pair<double, double> heightsAt(const UprightOutline& air, double fraction,
                                    double segmentLength) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vec2 p : air)
    if (std::abs(p.x - fraction) * segmentLength <= kHeightNoise)
      low = std::min(low, p.y), high = std::max(high, p.y);
  return {low, high};
}

}  // namespace hearth
