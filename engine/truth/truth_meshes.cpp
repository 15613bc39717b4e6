#include "truth/truth_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "math/predicates.h"
#include "truth/depth.h"
#include "truth/thing_sectors.h"

namespace hearth {

namespace {

std::array<double, 3> componentsOf(Vec3 v) { return {v.x, v.y, v.z}; }

/// Space sheared so that a ray runs along one of its axes (Woop, Benthin and Wald, "Watertight
/// Ray/Triangle Intersection", 2013). Each corner is rounded once, whichever face it is of: so the
/// faces that share it leave no gap between them.
class ShearedSpace {
 public:
  struct Place {
    Vec2 aside;  ///< from the ray, along the other two axes
    double t;    ///< ray parameter
  };

  ShearedSpace(Vec3 origin, Vec3 direction) : origin_(origin), direction_(componentsOf(direction)) {
    const auto isShorter = [](double a, double b) { return std::abs(a) < std::abs(b); };
    along_ = static_cast<std::size_t>(std::ranges::max_element(direction_, isShorter) -
                                      direction_.begin());
    right_ = (along_ + 1) % 3;
    up_ = (along_ + 2) % 3;
    // So that a face seen from its front runs from `right_` to `up_` whichever way the ray goes.
    if (direction_[along_] < 0) std::swap(right_, up_);
  }

  Place placeOf(Vec3 p) const {
    const std::array<double, 3> offset = componentsOf(p - origin_);
    const double t = offset[along_] / direction_[along_];
    return {{offset[right_] - t * direction_[right_], offset[up_] - t * direction_[up_]}, t};
  }

 private:
  Vec3 origin_;
  std::array<double, 3> direction_;
  std::size_t along_;  ///< the axis of its largest component
  std::size_t right_;
  std::size_t up_;
};

/// Where a ray crosses the plane of a face, between its edges.
struct FaceCrossing {
  double t;
  std::array<double, 3> weights;  ///< of the corners; >= 0, and their sum is 1
  bool isFront;                   ///< seen from there
};

/// None if the ray passes the face by, or sees it edge-on. Edges belong to it.
std::optional<FaceCrossing> faceCrossingOf(const ShearedSpace& space, const MeshFace& face) {
  std::array<ShearedSpace::Place, 3> places;
  std::ranges::transform(face.corners, places.begin(),
                         [&](Vec3 corner) { return space.placeOf(corner); });
  const int side = orientation(places[0].aside, places[1].aside, places[2].aside);
  if (side == 0) return std::nullopt;

  FaceCrossing found{0, {}, side > 0};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 from = places[(i + 1) % 3].aside;
    const Vec2 to = places[(i + 2) % 3].aside;
    if (side * orientation(from, to, {}) < 0) return std::nullopt;
    found.weights[i] = std::max(0.0, side * cross(from, to));
    sum += found.weights[i];
  }
  if (!(sum > 0)) return std::nullopt;  // narrower than rounding
  for (std::size_t i = 0; i < 3; ++i) {
    found.weights[i] /= sum;
    found.t += found.weights[i] * places[i].t;
  }
  return found;
}

/// One ray in one stretch of air, at one mesh.
class MeshMeeting {
 public:
  MeshMeeting(const Level& level, Vec3 origin, Vec3 direction, const AirStretch& stretch)
      : level_(level),
        origin_(origin),
        direction_(direction),
        stretch_(stretch),
        space_(origin, direction) {}

  std::optional<TruthHit> nearestOf(const Mesh& mesh) const {
    std::optional<FaceCrossing> best;
    std::uint32_t bestFace = 0;
    for (std::uint32_t i = mesh.firstFace; i < mesh.firstFace + mesh.faceCount; ++i) {
      const MeshFace& face = level_.meshFaces[i];
      const std::optional<FaceCrossing> crossing = faceCrossingOf(space_, face);
      if (!crossing || !(crossing->t > 0) || !isIn(stretch_, crossing->t)) continue;
      if (!crossing->isFront && !mesh.isTwoSided) continue;
      if (frontOf(face) == Vec3{}) continue;  // a line, which rounding has turned aside
      if (best && best->t <= crossing->t) continue;
      best = crossing;
      bestFace = i;
    }
    return best ? std::optional(hitOn(mesh, bestFace, *best)) : std::nullopt;
  }

 private:
  TruthHit hitOn(const Mesh& mesh, std::uint32_t index, const FaceCrossing& crossing) const {
    const MeshFace& face = level_.meshFaces[index];
    const Vec3 front = frontOf(face);
    TruthHit found;
    found.kind = SurfaceKind::Mesh;
    found.sector = mesh.sector;
    found.mesh = mesh.surface;
    found.face = index;
    found.point = origin_ + crossing.t * direction_;
    found.normal = ((crossing.isFront ? 1 : -1) / length(front)) * front;
    found.t = crossing.t;
    found.texture = TextureMapping{};  // one repeat for each unit of the face's image coordinates
    found.texture->texture = face.texture;
    for (std::size_t i = 0; i < 3; ++i)
      found.imageMetres = found.imageMetres + crossing.weights[i] * face.image[i];
    return found;
  }

  const Level& level_;
  Vec3 origin_;
  Vec3 direction_;
  const AirStretch& stretch_;
  ShearedSpace space_;
};

std::vector<Polygon> facesAsPolygons(const Level& level, const Mesh& mesh) {
  std::vector<Polygon> faces;
  for (const MeshFace& face : level.facesOf(mesh))
    faces.emplace_back(face.corners.begin(), face.corners.end());
  return faces;
}

}  // namespace

TruthMeshes::TruthMeshes(const Level& level) : level_(level) {
  for (const Mesh& mesh : level.meshes)
    isIn_.push_back(sectorsCrossedBy(level, mesh.sector, facesAsPolygons(level, mesh)));
}

std::optional<TruthHit> TruthMeshes::nearest(Vec3 origin, Vec3 direction,
                                             const AirStretch& stretch) const {
  const MeshMeeting meeting(level_, origin, direction, stretch);
  std::optional<TruthHit> best;
  for (std::size_t i = 0; i < level_.meshes.size(); ++i) {
    if (!isIn_[i][stretch.sector.index()]) continue;
    const std::optional<TruthHit> hit = meeting.nearestOf(level_.meshes[i]);
    if (hit && (!best || hides(hit->t, best->t))) best = hit;
  }
  return best;
}

}  // namespace hearth
