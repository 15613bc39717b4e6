#include "agreement/mesh_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "level/locate.h"
#include "math/tolerance.h"
#include "truth/trace.h"

namespace hearth::agreement {

namespace {

Vec3 normalOf(const MeshFace& face) {
  const Vec3 front = frontOf(face);
  return (1 / length(front)) * front;
}

/// Along the contour line and the steepest ascent, or along x and y.
Axes axesOf(const MeshFace& face) {
  const Vec3 normal = normalOf(face);
  const Vec2 flat = normal.xy();
  if (length(flat) < 1e-9) return {{0, 0, face.corners[0].z}, {1, 0, 0}, {0, 1, 0}};
  const Vec2 contour = unit(turned90(flat));
  const Vec3 s{contour.x, contour.y, 0};
  const Vec3 t = cross(normal, s);
  return {face.corners[0], s, t.z < 0 ? -1 * t : t};
}

bool haveCommonEdge(const MeshFace& a, const MeshFace& b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (a.corners[i] == b.corners[(k + 1) % 3] && a.corners[(i + 1) % 3] == b.corners[k])
        return true;
  return false;
}

bool areInOnePlane(const MeshFace& a, const MeshFace& b) {
  const Vec3 normal = normalOf(a);
  return dot(normal, normalOf(b)) > 0 && std::ranges::all_of(b.corners, [&](Vec3 corner) {
           return std::abs(dot(normal, corner - a.corners[0])) < 1e-12;
         });
}

bool isSmall(const MeshFace& face, double texel) {
  const Axes axes = axesOf(face);
  std::array<Vec2, 3> at;
  std::ranges::transform(face.corners, at.begin(), [&](Vec3 corner) { return axes.of(corner); });
  const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x});
  const auto [low, high] = std::minmax({at[0].y, at[1].y, at[2].y});
  const double limit = texel * (1 + 1e-6);
  return right - left <= limit && high - low <= limit;
}

/// Texels are counted from the least places along the axes, in upright ones from z = 0.
void moveOrigin(Axes& axes, const std::vector<MeshFace>& faces) {
  if (axes.s == Vec3{1, 0, 0} && axes.t == Vec3{0, 1, 0}) return;
  Vec2 least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const MeshFace& face : faces)
    for (const Vec3 corner : face.corners) {
      const Vec2 at = axes.of(corner);
      least = {std::min(least.x, at.x), std::min(least.y, at.y)};
    }
  if (std::abs(1 - axes.t.z) < 1e-12) least.y = -axes.origin.z;
  axes.origin = axes.at(least);
}

/// Those of all faces that no two share.
std::vector<Edge> bordersOf(const std::vector<MeshFace>& faces, const Axes& axes) {
  std::vector<Edge> edges;
  for (const MeshFace& face : faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 from = face.corners[k];
      const Vec3 to = face.corners[(k + 1) % 3];
      const bool isShared = std::ranges::any_of(faces, [&](const MeshFace& other) {
        for (std::size_t i = 0; i < 3; ++i)
          if (other.corners[i] == to && other.corners[(i + 1) % 3] == from) return true;
        return false;
      });
      if (isShared) continue;
      const Vec2 a = axes.of(from);
      const Vec2 b = axes.of(to);
      const bool isInFront = cross(b - a, axes.of(face.corners[(k + 2) % 3]) - a) > 0;
      edges.push_back(isInFront ? Edge{a, b} : Edge{b, a});
    }
  return edges;
}

/// Where a line, in lengths of `direction`, meets a face; none where it does not.
std::optional<double> meet(const MeshFace& face, Vec3 origin, Vec3 direction) {
  const Vec3 front = frontOf(face);
  const double speed = dot(front, direction);
  if (speed == 0) return std::nullopt;
  const double t = dot(front, face.corners[0] - origin) / speed;
  const Vec3 p = origin + t * direction;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 from = face.corners[k];
    const Vec3 to = face.corners[(k + 1) % 3];
    if (dot(front, cross(p - from, to - from)) < 0) return std::nullopt;
  }
  return t;
}

}  // namespace

const MeshPiece& MeshPieces::pieceOf(std::uint32_t face) {
  const Level& level = scene_.level();
  if (const auto found = pieceOfFace_.find(face); found != pieceOfFace_.end())
    return pieces_.at(found->second);
  std::size_t mesh = 0;
  while (face >= level.meshes[mesh].firstFace + level.meshes[mesh].faceCount) ++mesh;
  const bool isSmallFace = isSmall(level.meshFaces[face], level.bake.texel);
  MeshPiece piece{mesh, isSmallFace ? std::vector{face} : joinedWith(face, mesh), isSmallFace, {}};
  std::vector<MeshFace> faces;
  for (const std::uint32_t part : piece.faces) faces.push_back(level.meshFaces[part]);
  Panel& panel = piece.panel;
  panel.sector = level.meshes[mesh].sector;
  panel.normal = normalOf(faces.front());
  panel.axes = axesOf(faces.front());
  moveOrigin(panel.axes, faces);
  panel.edges = bordersOf(faces, panel.axes);
  const std::size_t first = piece.faces.front();
  for (const std::uint32_t part : piece.faces) pieceOfFace_[part] = first;
  return pieces_[first] = std::move(piece);
}

std::vector<std::uint32_t> MeshPieces::joinedWith(std::uint32_t face, std::size_t mesh) const {
  const Level& level = scene_.level();
  const Mesh& whole = level.meshes[mesh];
  std::vector<std::uint32_t> joined{face};
  for (std::size_t next = 0; next < joined.size(); ++next)
    for (std::uint32_t other = whole.firstFace; other < whole.firstFace + whole.faceCount; ++other)
      if (std::ranges::find(joined, other) == joined.end() &&
          !isSmall(level.meshFaces[other], level.bake.texel) &&
          haveCommonEdge(level.meshFaces[joined[next]], level.meshFaces[other]) &&
          areInOnePlane(level.meshFaces[joined[next]], level.meshFaces[other]))
        joined.push_back(other);
  std::ranges::sort(joined);
  return joined;
}

bool MeshPieces::isInAir(std::size_t mesh, Vec3 point) const {
  return std::ranges::any_of(scene_.level().meshesBySector, [&](const MeshInSector& at) {
    return at.mesh == mesh && contains(scene_, scene_[at.sector], point, kPositionSlack);
  });
}

bool MeshPieces::isInsideMesh(Vec3 point, Vec3 normal, SectorId sector) const {
  const Level& level = scene_.level();
  if (level.meshesIn(sector).empty()) return false;
  bool isBack = false;
  // Of the meshes in the sector of the point, those that are in the sector of a stretch, too. What
  // is no more than kArrival apart touches: then the point is in the mesh whose back it is.
  const auto nearestIn = [&](const AirStretch& air) -> std::optional<TruthHit> {
    std::optional<double> nearest;
    for (const MeshInSector& at : level.meshesIn(sector)) {
      const Mesh& mesh = level.meshes[at.mesh];
      const auto isHere = [&](const MeshInSector& there) { return there.mesh == at.mesh; };
      if (!mesh.castsShadow || mesh.isTwoSided) continue;
      if (std::ranges::none_of(level.meshesIn(air.sector), isHere)) continue;
      for (const MeshFace& face : level.facesOf(mesh)) {
        const std::optional<double> t = meet(face, point, normal);
        if (!t || *t < std::max(kArrival, air.tEnter - kArrival)) continue;
        if (*t > air.tLeave + kArrival) continue;
        const bool isBackHere = dot(frontOf(face), normal) > 0;
        const double place = isBackHere ? *t - kArrival : *t;
        if (nearest && place >= *nearest) continue;
        nearest = place;
        isBack = isBackHere;
      }
    }
    return nearest ? std::optional(TruthHit{}) : std::nullopt;
  };
  SurfacePoint onTheLine{};
  onTheLine.point = point + (1 + kNudge) * normal;  // so that parameters are metres
  traceLight(level, sector, point + kNudge * normal, onTheLine, nearestIn);
  return isBack;
}

}  // namespace hearth::agreement
