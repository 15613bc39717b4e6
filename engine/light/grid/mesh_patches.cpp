#include "light/grid/mesh_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "light/grid/plane.h"
#include "light/ray_error.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// More would make finding a sample's place slow.
constexpr std::size_t kMaxFacesOfPatch = 256;

using Polygon = std::vector<Vec2>;

Plane planeOf(const MeshFace& face) {
  const Vec3 front = frontOf(face);
  return {face.corners[0], (1 / length(front)) * front};
}

bool isBefore(Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// Of some faces in a plane. Begins at their least places along its axes, of what is upright at z =
/// 0: so rounding moves it by no more than itself.
TexelGrid gridOf(const Plane& plane, std::span<const MeshFace> faces, double texel) {
  constexpr double kRounding = 1e-9;  // of a normal's components
  const Vec2 flat = plane.normal.xy();
  if (length(flat) < kRounding) return {{0, 0, plane.point.z}, {1, 0, 0}, {0, 1, 0}, texel};
  const Vec2 contour = unit(turned90(flat));
  TexelGrid grid{plane.point, {contour.x, contour.y, 0}, {}, texel};
  const Vec3 ascent = cross(plane.normal, grid.axisS);
  grid.axisT = ascent.z < 0 ? -1 * ascent : ascent;
  Vec2 least;  // metres from `plane.point`
  for (const MeshFace& face : faces)
    for (const Vec3 corner : face.corners) {
      const Vec3 offset = corner - plane.point;
      least = {std::min(least.x, dot(offset, grid.axisS)),
               std::min(least.y, dot(offset, grid.axisT))};
    }
  if (std::abs(plane.normal.z) < kRounding) least.y = -plane.point.z;
  grid.origin = plane.point + least.x * grid.axisS + least.y * grid.axisT;
  return grid;
}

/// As large as a texel is small, too, whatever rounding makes of it.
bool isSmall(const MeshFace& face, double texel) {
  if (frontOf(face) == Vec3{}) return true;  // too small for numbers
  const TexelGrid grid = gridOf(planeOf(face), std::span(&face, 1), texel);
  const auto [a, b, c] = std::array{grid.toTexels(face.corners[0]), grid.toTexels(face.corners[1]),
                                    grid.toTexels(face.corners[2])};
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  return right - left <= 1 + kFilterSlack && bottom - top <= 1 + kFilterSlack;
}

/// Whether faces face the same way in one plane, but for rounding.
bool areCoplanar(const MeshFace& a, const MeshFace& b) {
  const Plane plane = planeOf(a);
  if (dot(plane.normal, planeOf(b).normal) <= 0) return false;
  return std::ranges::all_of(b.corners, [&](Vec3 corner) {
    const double size = largestCoordinate(corner) + length(corner - plane.point);
    return std::abs(plane.inFront(corner)) <= roundingOf(size);
  });
}

/// Sets of faces that are joined one by one.
class JoinedFaces {
 public:
  explicit JoinedFaces(std::size_t count) : first_(count), size_(count, 1) {
    std::iota(first_.begin(), first_.end(), std::size_t{0});
  }

  std::size_t firstOf(std::size_t face) {
    while (first_[face] != face) face = first_[face] = first_[first_[face]];
    return face;
  }

  /// Unless that makes too many.
  void join(std::size_t a, std::size_t b) {
    a = firstOf(a);
    b = firstOf(b);
    if (a == b || size_[a] + size_[b] > kMaxFacesOfPatch) return;
    if (b < a) std::swap(a, b);
    first_[b] = a;
    size_[a] += size_[b];
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::size_t> size_;
};

/// An edge, from the corner that comes first.
struct FaceEdge {
  Vec3 from;
  Vec3 to;
  std::uint32_t face;
  bool isReversed;  ///< in the face

  auto ends() const { return std::tie(from.x, from.y, from.z, to.x, to.y, to.z); }
};

std::vector<FaceEdge> sortedEdges(std::span<const MeshFace> faces,
                                  std::span<const std::uint32_t> which) {
  std::vector<FaceEdge> edges;
  edges.reserve(3 * which.size());
  for (const std::uint32_t face : which)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 from = faces[face].corners[i];
      const Vec3 to = faces[face].corners[(i + 1) % 3];
      const bool isReversed = isBefore(to, from);
      edges.push_back({isReversed ? to : from, isReversed ? from : to, face, isReversed});
    }
  std::ranges::stable_sort(
      edges, [](const FaceEdge& a, const FaceEdge& b) { return a.ends() < b.ends(); });
  return edges;
}

/// Groups of faces, each in rising order, in the order of their first faces.
std::vector<std::vector<std::uint32_t>> coplanarGroups(std::span<const MeshFace> faces,
                                                       std::span<const std::uint32_t> which) {
  JoinedFaces joined(faces.size());
  const std::vector<FaceEdge> edges = sortedEdges(faces, which);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const FaceEdge& a = edges[i - 1];
    const FaceEdge& b = edges[i];
    if (a.ends() == b.ends() && a.isReversed != b.isReversed &&
        areCoplanar(faces[a.face], faces[b.face]))
      joined.join(a.face, b.face);
  }
  std::map<std::size_t, std::vector<std::uint32_t>> groups;
  for (const std::uint32_t face : which) groups[joined.firstOf(face)].push_back(face);
  std::vector<std::vector<std::uint32_t>> list;
  for (auto& [first, group] : groups) list.push_back(std::move(group));
  return list;
}

/// The border of a group; none where it does not run round it once for each corner.
std::optional<std::vector<Polygon>> borderOf(std::span<const MeshFace> faces,
                                             std::span<const std::uint32_t> group,
                                             const TexelGrid& grid) {
  const auto less = [](Vec3 a, Vec3 b) { return isBefore(a, b); };
  std::map<Vec3, Vec3, decltype(less)> next(less);
  const std::vector<FaceEdge> edges = sortedEdges(faces, group);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const FaceEdge& edge = edges[i];
    const bool isShared = (i > 0 && edges[i - 1].ends() == edge.ends()) ||
                          (i + 1 < edges.size() && edges[i + 1].ends() == edge.ends());
    if (isShared) continue;
    const auto [from, to] =
        edge.isReversed ? std::pair(edge.to, edge.from) : std::pair(edge.from, edge.to);
    if (!next.try_emplace(from, to).second) return std::nullopt;
  }
  std::vector<Polygon> border;
  while (!next.empty()) {
    Polygon& loop = border.emplace_back();
    for (auto at = next.begin(); at != next.end();) {
      loop.push_back(grid.toTexels(at->first));
      const Vec3 to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    if (loop.size() < 3) return std::nullopt;
  }
  return border;
}

std::vector<Polygon> trianglesOf(std::span<const MeshFace> faces,
                                 std::span<const std::uint32_t> group, const TexelGrid& grid) {
  std::vector<Polygon> triangles;
  for (const std::uint32_t face : group) {
    Polygon& triangle = triangles.emplace_back();
    for (const Vec3 corner : faces[face].corners) triangle.push_back(grid.toTexels(corner));
  }
  return triangles;
}

MeshPatch patchOf(std::span<const MeshFace> faces, std::vector<std::uint32_t> group, double texel) {
  const Plane plane = planeOf(faces[group.front()]);
  std::vector<MeshFace> ofGroup;
  for (const std::uint32_t face : group) ofGroup.push_back(faces[face]);
  MeshPatch patch;
  LitSurface& surface = patch.surface;
  surface.grid = gridOf(plane, ofGroup, texel);
  surface.anchor = plane.point;
  surface.normal = plane.normal;
  const std::vector<Polygon> triangles = trianglesOf(faces, group, surface.grid);
  surface.texels = texelsAround(triangles);
  surface.outline = Polygons(borderOf(faces, group, surface.grid).value_or(triangles));
  patch.faces = std::move(group);
  return patch;
}

}  // namespace

DividedMesh dividedMesh(std::span<const MeshFace> faces, double texel) {
  DividedMesh divided;
  std::vector<std::uint32_t> large;
  for (std::size_t i = 0; i < faces.size(); ++i)
    (isSmall(faces[i], texel) ? divided.smallFaces : large)
        .push_back(static_cast<std::uint32_t>(i));
  for (std::vector<std::uint32_t>& group : coplanarGroups(faces, large))
    divided.patches.push_back(patchOf(faces, std::move(group), texel));
  return divided;
}

}  // namespace hearth
