#include "agreement/common_edges.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "level/locate.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth::agreement {

namespace {

constexpr double kRounding = 1e-7;  ///< metres: clipping leaves edges of which nothing is true

/// Whether all corners of the panel lie within what an author cannot mean of the plane.
bool liesInPlaneOf(const Panel& plane, const Panel& panel) {
  return std::ranges::all_of(panel.edges, [&](const Edge& edge) {
    return std::abs(plane.distanceInFront(panel.axes.at(edge.a))) <= kAuthorNoise;
  });
}

/// Metres that what an author writes about this edge may be off.
double noiseOf(const Edge& edge) {
  return std::clamp(kAuthorNoiseOfEdge * length(edge.b - edge.a), kRounding, kAuthorNoise);
}

/// A point of the panel's plane, within noise, in its axes. Slopes have their corners from the map:
/// those of two planes that noise parts lie above one another, not along the normal.
Vec2 inPlane(const Panel& panel, Vec3 p) {
  if (panel.normal.z != 0) p.z -= panel.distanceInFront(p) / panel.normal.z;
  return panel.axes.of(p);
}

/// The part of `edge` along which `other` runs the opposite way.
std::optional<Edge> overlap(const Edge& edge, const Edge& other, double noise) {
  const double size = length(edge.b - edge.a);
  const Vec2 along = (1 / size) * (edge.b - edge.a);
  if (std::abs(cross(along, other.a - edge.a)) > noise) return std::nullopt;
  if (std::abs(cross(along, other.b - edge.a)) > noise) return std::nullopt;
  const double begin = std::max(0.0, dot(along, other.b - edge.a));
  const double end = std::min(size, dot(along, other.a - edge.a));
  if (end - begin <= noise) return std::nullopt;
  return Edge{edge.a + begin * along, edge.a + end * along};
}

/// Whether the step from one point to another passes the wall from its front.
bool passes(const Segment& wall, Vec2 from, Vec2 to) {
  return orientation(wall.p0, wall.p1, from) >= 0 && orientation(wall.p0, wall.p1, to) < 0 &&
         orientation(from, to, wall.p0) * orientation(from, to, wall.p1) <= 0;
}

/// To what sectors a short step out of a sector leads: through walls that open at its height, and
/// through flat portals.
std::vector<SectorId> acrossStep(const Scene& scene, const Sector& sector, Vec3 from, Vec3 to) {
  std::vector<SectorId> found;
  for (const Segment& wall : scene.segmentsOf(sector)) {
    if (!passes(wall, from.xy(), to.xy())) continue;
    for (const WallPiece& piece : scene.piecesOf(wall))
      if (const Opening* opening = std::get_if<Opening>(&piece.content))
        if (from.z >= piece.zBottom && from.z <= piece.zTop) found.push_back(opening->next);
  }
  const auto append = [&](const std::vector<SectorId>& members) {
    found.insert(found.end(), members.begin(), members.end());
  };
  if (sector.floor.flatPortal && to.z < sector.floor.z)
    append(scene[*sector.floor.flatPortal].lower);
  if (sector.ceiling.flatPortal && to.z > sector.ceiling.z)
    append(scene[*sector.ceiling.flatPortal].upper);
  return found;
}

/// Points on half a circle round the middle of an edge of the panel, in front of it: from over the
/// panel to beyond the edge.
std::vector<Vec3> pointsRound(const Panel& panel, const Edge& edge, double radius) {
  constexpr int kPoints = 180;
  const Vec2 middle = lerp(edge.a, edge.b, 0.5);
  const Vec3 over = panel.axes.at(middle + inward(edge)) - panel.axes.at(middle);
  // Straight up or down from slopes, so as to stay on the same side of the edge on the map.
  const double up = panel.normal.z;
  const Vec3 ahead = up == 0 ? panel.normal : Vec3{0, 0, std::copysign(1.0, up)};
  std::vector<Vec3> points;
  for (int i = 0; i < kPoints; ++i) {
    const SinCos turn = sinCosDegrees((i + 0.5) * 180 / kPoints);
    points.push_back(panel.axes.at(middle) + radius * (turn.cos * over + turn.sin * ahead));
  }
  return points;
}

/// Whether steps round the edge lead to the air of a sector. What stands in the way, once one is in
/// the air of a sector, does not matter: the point of a pillar that touches the edge cuts nothing
/// in two.
bool leadsRound(const Scene& scene, const Panel& from, SectorId to, const Edge& edge,
                double radius) {
  const std::vector<Vec3> points = pointsRound(from, edge, radius);
  std::vector<SectorId> reached{from.sector};
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Sector& sector = scene[reached[i]];
      if (!contains(scene, sector, points[k], 0)) continue;
      for (const SectorId next : acrossStep(scene, sector, points[k], points[k + 1])) {
        const bool isNew = std::ranges::find(reached, next) == reached.end();
        if (isNew && contains(scene, scene[next], points[k + 1], 0)) reached.push_back(next);
      }
    }
  return std::ranges::find(reached, to) != reached.end();
}

/// Whether air joins the panels across the edge: so far in front of it as authors may be off or, in
/// case that something else stands there, hardly in front.
bool isOpen(const Scene& scene, const Panel& from, const Panel& to, const Edge& edge) {
  if (from.sector == to.sector) return true;
  return leadsRound(scene, from, to.sector, edge, 5 * kAuthorNoise) ||
         leadsRound(scene, from, to.sector, edge, kAuthorNoise / 100);
}

/// The edge cut wherever it passes one of the corners: between them it is open or not as a whole.
std::vector<Edge> cutAt(const std::vector<Vec3>& corners, const Axes& axes, const Edge& edge) {
  const double size = length(edge.b - edge.a);
  const Vec2 along = (1 / size) * (edge.b - edge.a);
  const Vec3 a = axes.at(edge.a);
  std::vector<double> cuts{0, size};
  for (const Vec3 corner : corners) {
    const double s = dot(along, axes.of(corner) - edge.a);
    if (s <= kRounding || s >= size - kRounding) continue;
    if (length(corner - a - (axes.at(s * along) - axes.origin)) < kAuthorNoise) cuts.push_back(s);
  }
  std::ranges::sort(cuts);
  std::vector<Edge> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    if (cuts[i + 1] - cuts[i] > kRounding)
      parts.push_back({edge.a + cuts[i] * along, edge.a + cuts[i + 1] * along});
  return parts;
}

}  // namespace

std::vector<Vec3> cornersOf(const Scene& scene, const std::vector<std::optional<Panel>>& panels) {
  std::vector<Vec3> corners;
  for (const std::optional<Panel>& panel : panels)
    if (panel)
      for (const Edge& edge : panel->edges) corners.push_back(panel->axes.at(edge.a));
  for (const Segment& wall : scene.level().segments)
    for (const WallPiece& piece : scene.piecesOf(wall))
      for (const double z : {piece.zBottom, piece.zTop}) {
        corners.push_back({wall.p0.x, wall.p0.y, z});
        corners.push_back({wall.p1.x, wall.p1.y, z});
      }
  return corners;
}

bool areInOnePlane(const Panel& a, const Panel& b) {
  return length(a.normal - b.normal) <= kAuthorNoiseOfEdge && liesInPlaneOf(a, b) &&
         liesInPlaneOf(b, a);
}

std::vector<Edge> commonEdges(const Scene& scene, const std::vector<Vec3>& corners,
                              const Panel& from, const Panel& to) {
  std::vector<Edge> common;
  for (const Edge& edge : from.edges)
    for (const Edge& other : to.edges) {
      const Vec3 a = to.axes.at(other.a);
      const Vec3 b = to.axes.at(other.b);
      const double noise = std::min(noiseOf(edge), noiseOf(other));
      if (std::abs(from.distanceInFront(a)) > noise) continue;
      if (std::abs(from.distanceInFront(b)) > noise) continue;
      const std::optional<Edge> shared = overlap(edge, {inPlane(from, a), inPlane(from, b)}, noise);
      if (!shared) continue;
      for (const Edge& part : cutAt(corners, from.axes, *shared))
        if (isOpen(scene, from, to, part)) common.push_back(part);
    }
  return common;
}

}  // namespace hearth::agreement
