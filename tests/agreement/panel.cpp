#include "agreement/panel.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth::agreement {

namespace {

constexpr double kRoundingOfMargin = 1e-3;  ///< fraction: of 10^-6 m, that of coordinates of 10^6 m
constexpr double kLeastSine = 1e-6;         ///< of a corner; a sharper one has its inside 1 m away

/// Heights over a wall: at its p0 and at its p1.
struct Heights {
  double at0;
  double at1;
};

/// A convex outline of a part of a wall, of `length` metres: s to the right, z up.
class WallOutline {
 public:
  WallOutline(double length, double zBottom, double zTop)
      : length_(length), corners_{{0, zBottom}, {length, zBottom}, {length, zTop}, {0, zTop}} {}

  void keepAbove(Heights z) { keep(z, 1); }
  void keepBelow(Heights z) { keep(z, -1); }

  std::vector<Edge> edges() const {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Edge edge{corners_[i], corners_[(i + 1) % corners_.size()]};
      if (length(edge.b - edge.a) > 0) edges.push_back(edge);
    }
    return edges;
  }

 private:
  void keep(Heights z, double sign) {
    const auto above = [&](Vec2 p) {
      return sign * (p.y - std::lerp(z.at0, z.at1, p.x / length_));
    };
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Vec2 a = corners_[i];
      const Vec2 b = corners_[(i + 1) % corners_.size()];
      if (above(a) >= 0) kept.push_back(a);
      if ((above(a) < 0) != (above(b) < 0))
        kept.push_back(lerp(a, b, above(a) / (above(a) - above(b))));
    }
    corners_ = kept;
  }

  double length_;
  std::vector<Vec2> corners_;
};

double distanceToEdge(const Edge& edge, Vec2 st) {
  return length(nearestOnSegment(edge.a, edge.b, st) - st);
}

/// The point before both edges that is `margin` from each; none where they form no corner.
std::optional<Vec2> inCorner(const Edge& a, const Edge& b, double margin) {
  const Vec2 alongA = turned90(inward(a));
  const double sine = dot(alongA, inward(b));
  if (!(std::abs(sine) > kLeastSine)) return std::nullopt;
  const Vec2 onA = a.a + margin * inward(a);
  const Vec2 p = onA + (margin - dot(onA - b.a, inward(b))) / sine * alongA;
  const auto isBeside = [&](const Edge& edge) {
    return distanceToEdge(edge, p) < (1 + kRoundingOfMargin) * margin;
  };
  return isBeside(a) && isBeside(b) ? std::optional(p) : std::nullopt;
}

Heights floorOver(const Scene& scene, const Sector& sector, const Segment& wall) {
  return {scene.airBottom(sector, wall.p0), scene.airBottom(sector, wall.p1)};
}

Heights ceilingOver(const Scene& scene, const Sector& sector, const Segment& wall) {
  return {scene.airTop(sector, wall.p0), scene.airTop(sector, wall.p1)};
}

/// The sector whose wedge the sidewall belongs to.
const Sector& sectorBehind(const Scene& scene, const Segment& wall,
                           const SurfaceGeometry& sidewall) {
  for (const WallPiece& piece : scene.piecesOf(wall))
    if (const Opening* opening = std::get_if<Opening>(&piece.content))
      if (piece.zBottom == sidewall.zBottom && piece.zTop == sidewall.zTop)
        return scene[opening->next];
  return scene[wall.sector];
}

Panel wallPanel(const Scene& scene, const Segment& wall, WallOutline outline) {
  outline.keepAbove(floorOver(scene, scene[wall.sector], wall));
  outline.keepBelow(ceilingOver(scene, scene[wall.sector], wall));
  const Vec2 along = (1 / wall.length) * (wall.p1 - wall.p0);
  const Vec2 normal = turned90(along);
  return {wall.sector,
          {normal.x, normal.y, 0},
          {{wall.p0.x, wall.p0.y, 0}, {along.x, along.y, 0}, {0, 0, 1}},
          outline.edges()};
}

/// Contour line and steepest ascent; x and y where there is none.
Axes axesOf(Vec2 gradient, Vec3 origin) {
  const double steepness = length(gradient);
  if (steepness < 1e-9) return {origin, {1, 0, 0}, {0, 1, 0}};
  const Vec2 up = (1 / steepness) * gradient;
  const double scale = 1 / std::sqrt(1 + steepness * steepness);
  return {origin, {up.y, -up.x, 0}, scale * Vec3{up.x, up.y, steepness}};
}

Panel flatPanel(const Scene& scene, const Surface& surface) {
  const Sector& sector = scene[surface.sector];
  const bool isOver = facesDown(surface.kind);
  const auto z = [&](Vec2 p) {
    return isOver ? scene.airTop(sector, p) : scene.airBottom(sector, p);
  };
  const std::optional<Slope>& slope = isOver ? sector.ceilingSlope : sector.floorSlope;
  const Vec2 gradient = slope ? slope->gradient : Vec2{};
  const double scale = (isOver ? -1 : 1) / std::sqrt(1 + dot(gradient, gradient));
  Panel panel{surface.sector,
              scale * Vec3{-gradient.x, -gradient.y, 1},
              axesOf(gradient, {0, 0, z({0, 0})}),
              {}};
  for (const Segment& wall : scene.segmentsOf(sector))
    panel.edges.push_back({panel.axes.of({wall.p0.x, wall.p0.y, z(wall.p0)}),
                           panel.axes.of({wall.p1.x, wall.p1.y, z(wall.p1)})});
  return panel;
}

}  // namespace

Vec2 inward(const Edge& edge) {
  const Vec2 along = edge.b - edge.a;
  return (1 / length(along)) * turned90(along);
}

bool Panel::contains(Vec2 st) const {
  bool inside = false;
  for (const Edge& edge : edges)
    if ((edge.a.y <= st.y) != (edge.b.y <= st.y))
      if ((orientation(edge.a, edge.b, st) > 0) == (edge.b.y <= st.y)) inside = !inside;
  return inside;
}

Vec2 Panel::nearestOnEdge(Vec2 st) const {
  Vec2 best = edges.front().a;
  for (const Edge& edge : edges) {
    const Vec2 point = nearestOnSegment(edge.a, edge.b, st);
    if (length(point - st) < length(best - st)) best = point;
  }
  return best;
}

double Panel::distanceTo(Vec2 st) const {
  return contains(st) ? 0 : length(nearestOnEdge(st) - st);
}

std::vector<Vec2> Panel::movedInside(Vec2 st, double margin, Vec2 from) const {
  std::vector<Edge> beside;
  for (const Edge& edge : edges)
    if (distanceToEdge(edge, st) < margin && length(edge.b - edge.a) > margin)
      beside.push_back(edge);
  std::vector<Vec2> inside;
  const auto addIfClear = [&](Vec2 p) {
    const bool isClear = std::ranges::all_of(edges, [&](const Edge& edge) {
      return distanceToEdge(edge, p) > (1 - kRoundingOfMargin) * margin;
    });
    if (isClear && contains(p)) inside.push_back(p);
  };
  for (const Edge& edge : beside)
    addIfClear(st + (margin - dot(st - edge.a, inward(edge))) * inward(edge));
  for (std::size_t i = 0; i < beside.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (const std::optional<Vec2> p = inCorner(beside[i], beside[k], margin)) addIfClear(*p);
  if (inside.empty()) return {st};
  std::ranges::sort(inside, {}, [&](Vec2 p) { return length(p - from); });
  return inside;
}

Panel panelOf(const Scene& scene, const Segment& wall) {
  const Sector& sector = scene[wall.sector];
  return wallPanel(scene, wall, {wall.length, sector.floor.z, sector.ceiling.z});
}

Panel panelOf(const Scene& scene, SurfaceId id) {
  const Surface& surface = scene[id];
  if (!surface.segment) return flatPanel(scene, surface);
  const Segment& wall = scene[*surface.segment];
  const SurfaceGeometry& at = scene.geometryOf(id);
  WallOutline outline(wall.length, at.zBottom, at.zTop);
  if (surface.kind == SurfaceKind::FloorSidewall)
    outline.keepBelow(floorOver(scene, sectorBehind(scene, wall, at), wall));
  if (surface.kind == SurfaceKind::CeilingSidewall) {
    outline.keepAbove(ceilingOver(scene, sectorBehind(scene, wall, at), wall));
    outline.keepAbove(floorOver(scene, sectorBehind(scene, wall, at), wall));
  }
  return wallPanel(scene, wall, outline);
}

}  // namespace hearth::agreement
