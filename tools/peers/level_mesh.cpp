#include "peers/level_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "level/openings.h"

namespace hearth {

namespace {

double xAt(const Segment& edge, double y) {
  if (y == edge.p0.y) return edge.p0.x;
  if (y == edge.p1.y) return edge.p1.x;
  return edge.p0.x + (edge.p1.x - edge.p0.x) * (y - edge.p0.y) / (edge.p1.y - edge.p0.y);
}

/// A point of a wall: its fraction of the way from p0 to p1, and its height.
struct WallPoint {
  double fraction;
  double z;
};
using WallPolygon = std::vector<WallPoint>;

/// The part of a convex polygon on which `sign * (z - line)` is not negative; the line runs from
/// height z0 at fraction 0 to z1 at fraction 1 (Sutherland and Hodgman).
WallPolygon clipped(const WallPolygon& polygon, double z0, double z1, double sign) {
  const auto side = [&](WallPoint p) { return sign * (p.z - std::lerp(z0, z1, p.fraction)); };
  WallPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const WallPoint a = polygon[i];
    const WallPoint b = polygon[(i + 1) % polygon.size()];
    if (side(a) >= 0) kept.push_back(a);
    if ((side(a) > 0 && side(b) < 0) || (side(a) < 0 && side(b) > 0)) {
      const double k = side(a) / (side(a) - side(b));
      kept.push_back({std::lerp(a.fraction, b.fraction, k), std::lerp(a.z, b.z, k)});
    }
  }
  return kept;
}

class Mesher {
 public:
  explicit Mesher(const Scene& scene) : scene_(scene) {}

  std::vector<MeshTriangle> mesh() {
    // A closed sector has no air from which its flats could be seen.
    for (const Sector& sector : scene_.level().sectors)
      if (scene_.zFloor(sector) < scene_.zCeiling(sector)) addFlats(sector);
    for (const Segment& segment : scene_.level().segments) addWall(segment);
    return std::move(triangles_);
  }

 private:
  void addFlats(const Sector& sector) {
    for (const auto& triangle : trianglesOf(scene_.level(), sector)) {
      if (sector.floorSurface)
        addFlat(triangle, *sector.floorSurface, {0, 0, 1},
                [&](Vec2 p) { return scene_.airBottom(sector, p); });
      if (sector.ceilingSurface)
        addFlat(triangle, *sector.ceilingSurface, {0, 0, -1},
                [&](Vec2 p) { return scene_.airTop(sector, p); });
    }
  }

  template <typename HeightAt>
  void addFlat(const std::array<Vec2, 3>& at, SurfaceId surface, Vec3 side, HeightAt zAt) {
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = {at[i].x, at[i].y, zAt(at[i])};
    add(corners, surface, side);
  }

  void addWall(const Segment& segment) {
    const SegmentGeometry& near = scene_.geometryOf(segment);
    for (const WallPiece& piece : scene_.piecesOf(segment)) {
      WallPolygon polygon{{0, piece.zBottom}, {1, piece.zBottom}, {1, piece.zTop}, {0, piece.zTop}};
      polygon = clipped(polygon, near.air0.zBottom, near.air1.zBottom, 1);
      polygon = clipped(polygon, near.air0.zTop, near.air1.zTop, -1);
      if (const SurfaceId* surface = std::get_if<SurfaceId>(&piece.content)) {
        addPolygon(segment, *surface, polygon);
        continue;
      }
      const Opening& opening = std::get<Opening>(piece.content);
      const SegmentGeometry& far = scene_.geometryOf(scene_[opening.twin]);
      if (opening.floorSidewall)
        addPolygon(segment, *opening.floorSidewall,
                   clipped(polygon, far.air1.zBottom, far.air0.zBottom, -1));
      if (opening.ceilingSidewall)
        addPolygon(segment, *opening.ceilingSidewall,
                   clipped(polygon, far.air1.zTop, far.air0.zTop, 1));
      if (opening.maskedMiddle) addMaskedMiddle(segment, opening, polygon);
    }
  }

  /// As if it had no holes, before which the next sector's wedges stand.
  void addMaskedMiddle(const Segment& segment, const Opening& opening, WallPolygon polygon) {
    const SurfaceGeometry& middle = scene_.geometryOf(*opening.maskedMiddle);
    const SegmentGeometry& far = scene_.geometryOf(scene_[opening.twin]);
    polygon = clipped(polygon, middle.zBottom, middle.zBottom, 1);
    polygon = clipped(polygon, middle.zTop, middle.zTop, -1);
    if (opening.floorSidewall) polygon = clipped(polygon, far.air1.zBottom, far.air0.zBottom, 1);
    if (opening.ceilingSidewall) polygon = clipped(polygon, far.air1.zTop, far.air0.zTop, -1);
    addPolygon(segment, *opening.maskedMiddle, polygon);
  }

  void addPolygon(const Segment& segment, SurfaceId surface, const WallPolygon& polygon) {
    const Vec2 front = turned90(segment.p1 - segment.p0);
    const auto corner = [&](WallPoint p) {
      const Vec2 xy = lerp(segment.p0, segment.p1, p.fraction);
      return Vec3{xy.x, xy.y, p.z};
    };
    for (std::size_t i = 2; i < polygon.size(); ++i)
      add({corner(polygon[0]), corner(polygon[i - 1]), corner(polygon[i])}, surface,
          {front.x, front.y, 0});
  }

  void add(const std::array<Vec3, 3>& c, SurfaceId surface, Vec3 side) {
    const Vec3 a = c[1] - c[0];
    const Vec3 b = c[2] - c[0];
    const Vec3 normal{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    const double towardsSide = dot(normal, side);
    if (towardsSide != 0)
      triangles_.push_back({c, surface, (towardsSide > 0 ? 1.0 : -1.0) * normal});
  }

  Scene scene_;
  std::vector<MeshTriangle> triangles_;
};

}  // namespace

std::vector<std::array<Vec2, 3>> trianglesOf(const Level& level, const Sector& sector) {
  std::vector<double> ys;
  for (const Segment& segment : level.segmentsOf(sector)) ys.push_back(segment.p0.y);
  std::ranges::sort(ys);
  ys.erase(std::unique(ys.begin(), ys.end()), ys.end());

  // Between two successive heights of vertices, walls do not end: pairs of them bound trapezoids.
  std::vector<std::array<Vec2, 3>> triangles;
  for (std::size_t i = 1; i < ys.size(); ++i) {
    const double y0 = ys[i - 1];
    const double y1 = ys[i];
    std::vector<const Segment*> edges;
    for (const Segment& edge : level.segmentsOf(sector))
      if (std::min(edge.p0.y, edge.p1.y) <= y0 && std::max(edge.p0.y, edge.p1.y) >= y1)
        edges.push_back(&edge);
    std::ranges::sort(edges, {}, [&](const Segment* e) { return xAt(*e, y0) + xAt(*e, y1); });
    for (std::size_t k = 1; k < edges.size(); k += 2) {
      const Vec2 a{xAt(*edges[k - 1], y0), y0};
      const Vec2 b{xAt(*edges[k], y0), y0};
      const Vec2 c{xAt(*edges[k], y1), y1};
      const Vec2 d{xAt(*edges[k - 1], y1), y1};
      if (a.x < b.x) triangles.push_back({a, b, c});
      if (d.x < c.x) triangles.push_back({a, c, d});
    }
  }
  return triangles;
}

std::vector<MeshTriangle> meshOf(const Scene& scene) { return Mesher(scene).mesh(); }

std::vector<MeshTriangle> trianglesOf(const Scene& scene, const Mesh& model) {
  std::vector<MeshTriangle> triangles;
  for (const MeshFace& face : scene.level().facesOf(model))
    triangles.push_back({face.corners, model.surface, frontOf(face)});
  return triangles;
}

std::vector<MeshTriangle> meshInLight(const Scene& scene) {
  std::vector<MeshTriangle> mesh = meshOf(scene);
  std::erase_if(mesh, [&](const MeshTriangle& triangle) {
    const SurfaceKind kind = scene[triangle.surface].kind;
    return isSky(kind) || kind == SurfaceKind::MaskedMiddle;
  });
  for (const Mesh& model : scene.level().meshes)
    if (model.castsShadow) std::ranges::copy(trianglesOf(scene, model), std::back_inserter(mesh));
  return mesh;
}

}  // namespace hearth
