#include "truth/truth_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "math/line_part.h"
#include "math/predicates.h"
#include "math/tolerance.h"
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

/// One ray at the meshes of a level.
class MeshMeeting {
 public:
  MeshMeeting(const Level& level, Vec3 origin, Vec3 direction)
      : level_(level), origin_(origin), direction_(direction), space_(origin, direction) {}

  /// The nearest face of a mesh of those that count: `counts` answers for the index of a face, and
  /// where the ray, past its origin, crosses it.
  template <typename Counts>
  std::optional<TruthHit> nearestOf(const Mesh& mesh, Counts&& counts) const {
    std::optional<FaceCrossing> best;
    std::uint32_t bestFace = 0;
    for (std::uint32_t i = mesh.firstFace; i < mesh.firstFace + mesh.faceCount; ++i) {
      const MeshFace& face = level_.meshFaces[i];
      const std::optional<FaceCrossing> crossing = faceCrossingOf(space_, face);
      if (!crossing || !(crossing->t > 0) || !counts(i, *crossing)) continue;
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
  ShearedSpace space_;
};

std::vector<Polygon> facesAsPolygons(const Level& level, const Mesh& mesh) {
  std::vector<Polygon> faces;
  for (const MeshFace& face : level.facesOf(mesh))
    faces.emplace_back(face.corners.begin(), face.corners.end());
  return faces;
}

/// A line of light in a level. Its parameters are those of the ray that is traced along it.
class LightLine {
 public:
  /// A part of it, in metres from its origin.
  struct Part {
    double from;
    double to;
  };

  /// It meets faces in this part only, and not the face on which it starts or which it lights.
  LightLine(const Level& level, Vec3 origin, Vec3 direction, Part part,
            std::optional<std::uint32_t> itsFace)
      : meeting_(level, origin, direction),
        origin_(origin),
        direction_(direction),
        metresPerT_(length(direction)),
        part_(part),
        itsFace_(itsFace) {}

  Vec3 origin() const { return origin_; }
  Vec3 at(double t) const { return origin_ + t * direction_; }

  /// What of a mesh stops it in a stretch of air.
  std::optional<TruthHit> stopAt(const Mesh& mesh, const AirStretch& air) const {
    const AirStretch airMetres{air.sector, air.tEnter * metresPerT_, air.tLeave * metresPerT_};
    return meeting_.nearestOf(mesh, [&](std::uint32_t face, const FaceCrossing& crossing) {
      const double at = crossing.t * metresPerT_;
      return face != itsFace_ && part_.from < at && at < part_.to && isIn(airMetres, at);
    });
  }

 private:
  MeshMeeting meeting_;
  Vec3 origin_;
  Vec3 direction_;
  double metresPerT_;
  Part part_;
  std::optional<std::uint32_t> itsFace_;
};

}  // namespace

TruthMeshes::TruthMeshes(const Level& level) : level_(level) {
  for (const Mesh& mesh : level.meshes) {
    bounds_.push_back(boundsOf(level.facesOf(mesh)));
    isIn_.push_back(sectorsCrossedBy(level, mesh.sector, facesAsPolygons(level, mesh)));
  }
}

TruthMeshes::Bounds TruthMeshes::boundsOf(std::span<const MeshFace> faces) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  Bounds bounds{{kEndless, kEndless, kEndless}, {-kEndless, -kEndless, -kEndless}};
  for (const MeshFace& face : faces)
    for (const Vec3 p : face.corners) {
      const auto [min, max] = bounds;
      bounds.min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
      bounds.max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
    }
  return bounds;
}

/// Whether the line passes the bounds, or no farther from them than much more than rounding.
bool TruthMeshes::mayMeet(const Bounds& bounds, Vec3 origin, Vec3 end) {
  const std::array<double, 3> min = componentsOf(bounds.min);
  const std::array<double, 3> max = componentsOf(bounds.max);
  const std::array<double, 3> from = componentsOf(origin);
  const std::array<double, 3> to = componentsOf(end);
  std::optional<LinePart> inside = LinePart{};
  for (std::size_t i = 0; i < 3 && inside; ++i) {
    const double low = min[i] - kPositionSlack;
    const double high = max[i] + kPositionSlack;
    inside = keepPositive(*inside, from[i] - low, to[i] - low);
    if (inside) inside = keepPositive(*inside, high - from[i], high - to[i]);
  }
  return inside.has_value();
}

std::optional<TruthHit> TruthMeshes::nearest(Vec3 origin, Vec3 direction,
                                             const AirStretch& stretch) const {
  const MeshMeeting meeting(level_, origin, direction);
  std::optional<TruthHit> best;
  for (std::size_t i = 0; i < level_.meshes.size(); ++i) {
    if (!isIn_[i][stretch.sector.index()]) continue;
    const Mesh& mesh = level_.meshes[i];
    const std::optional<TruthHit> hit =
        meeting.nearestOf(mesh, [&](std::uint32_t, const FaceCrossing& crossing) {
          return (crossing.isFront || mesh.isTwoSided) && hearth::isIn(stretch, crossing.t);
        });
    if (hit && (!best || hides(hit->t, best->t))) best = hit;
  }
  return best;
}

MeetInAir TruthMeshes::shadowsOn(Vec3 origin, Vec3 end,
                                 std::optional<std::uint32_t> litFace) const {
  if (origin == end) return {};
  const Vec3 direction = end - origin;
  const LightLine::Part part{0, length(direction) - kArrival};
  return nearestOn(LightLine(level_, origin, direction, part, litFace), 1);
}

MeetInAir TruthMeshes::facesAhead(Vec3 origin, Vec3 direction,
                                  std::optional<std::uint32_t> startFace) const {
  double farthest = 0;
  for (const auto& [min, max] : bounds_)
    if (min.x <= max.x) farthest = std::max(farthest, length(min - origin) + length(max - min));
  const LightLine::Part part{kArrival, std::numeric_limits<double>::infinity()};
  return nearestOn(LightLine(level_, origin, direction, part, startFace), farthest);
}

/// Of what casts a shadow on the line up to `tEnd`.
template <typename Line>
MeetInAir TruthMeshes::nearestOn(const Line& line, double tEnd) const {
  std::vector<std::size_t> onTheWay;
  for (std::size_t i = 0; i < level_.meshes.size(); ++i)
    if (level_.meshes[i].castsShadow && mayMeet(bounds_[i], line.origin(), line.at(tEnd)))
      onTheWay.push_back(i);
  if (onTheWay.empty()) return {};
  return [this, line, onTheWay = std::move(onTheWay)](const AirStretch& air) {
    std::optional<TruthHit> nearest;
    for (const std::size_t i : onTheWay) {
      if (!isIn_[i][air.sector.index()]) continue;
      const std::optional<TruthHit> stop = line.stopAt(level_.meshes[i], air);
      if (stop && (!nearest || stop->t < nearest->t)) nearest = stop;
    }
    return nearest;
  };
}

bool TruthMeshes::isIn(SurfaceId mesh, SectorId sector) const {
  const std::size_t index = mesh.index() - level_.meshes.front().surface.index();
  return isIn_[index][sector.index()];
}

}  // namespace hearth
