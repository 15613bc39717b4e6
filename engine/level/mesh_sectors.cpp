#include "level/mesh_sectors.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "level/openings.h"
#include "level/plan_shape.h"
#include "math/box.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// What is left of a face that is cut by planes (Sutherland and Hodgman, 1974).
class ClippedFace {
 public:
  explicit ClippedFace(const MeshFace& face) : count_(face.corners.size()) {
    std::ranges::copy(face.corners, corners_.begin());
  }

  std::span<const Vec3> corners() const { return {corners_.data(), count_}; }

  /// Keeps where a linear function of the place is not below -kPositionSlack. False if that is
  /// nowhere. A face can be cut kMaxCuts times.
  template <typename Function>
  bool keep(Function&& function) {
    std::array<Vec3, kMaxCorners> kept;
    std::size_t count = 0;
    for (std::size_t i = 0; i < count_ && count + 2 <= kept.size(); ++i) {
      const Vec3 from = corners_[i];
      const Vec3 to = corners_[(i + 1) % count_];
      const double atFrom = function(from) + kPositionSlack;
      const double atTo = function(to) + kPositionSlack;
      if (atFrom >= 0) kept[count++] = from;
      if ((atFrom < 0) != (atTo < 0)) kept[count++] = from + atFrom / (atFrom - atTo) * (to - from);
    }
    corners_ = kept;
    count_ = count;
    return count > 0;
  }

 private:
  static constexpr std::size_t kMaxCuts = 10;
  /// Each cut adds at most one. Where rounding bends what is straight it may add more; then those
  /// for which there is no room are left out, no farther from the others than rounding.
  static constexpr std::size_t kMaxCorners = 3 + 2 * kMaxCuts;

  std::array<Vec3, kMaxCorners> corners_;
  std::size_t count_;
};

/// Whether a face crosses or touches an opening, where that is open.
bool crosses(const Scene& scene, const MeshFace& face, const Segment& segment,
             const WallPiece& piece, const Opening& opening) {
  const Vec2 along = (1 / segment.length) * (segment.p1 - segment.p0);
  const auto beside = [&](Vec3 p) { return cross(along, p.xy() - segment.p0); };
  const auto metres = [&](Vec3 p) { return dot(along, p.xy() - segment.p0); };
  const auto near = [&](Vec3 p) { return scene.airAt(segment, metres(p) / segment.length); };
  const auto far = [&](Vec3 p) {
    return scene.airAt(scene[opening.twin], 1 - metres(p) / segment.length);
  };
  ClippedFace part(face);
  if (!part.keep(beside) || !part.keep([&](Vec3 p) { return -beside(p); }) || !part.keep(metres) ||
      !part.keep([&](Vec3 p) { return segment.length - metres(p); }) ||
      !part.keep([&](Vec3 p) { return p.z - piece.zBottom; }) ||
      !part.keep([&](Vec3 p) { return piece.zTop - p.z; }) ||
      !part.keep([&](Vec3 p) { return p.z - near(p).zBottom; }) ||
      !part.keep([&](Vec3 p) { return near(p).zTop - p.z; }) ||
      !part.keep([&](Vec3 p) { return p.z - far(p).zBottom; }) ||
      !part.keep([&](Vec3 p) { return far(p).zTop - p.z; }))
    return false;
  // Where it is closed the floor of one side meets the ceiling of the other.
  return std::ranges::any_of(part.corners(), [&](Vec3 p) {
    const OpeningSpan span = openingSpan(piece, near(p), far(p));
    return span.zTop - span.zBottom > kPositionSlack;
  });
}

/// Whether a face crosses or touches the plane of a flat portal where both sectors have air.
bool crosses(const Level& level, const MeshFace& face, double z, const Sector& from,
             const Sector& to, std::vector<double>& cuts) {
  ClippedFace part(face);
  if (!part.keep([z](Vec3 p) { return p.z - z; }) || !part.keep([z](Vec3 p) { return z - p.z; }))
    return false;
  std::array<Vec2, PlanShape::kMaxCorners> plan;
  const std::size_t count = std::min(plan.size(), part.corners().size());
  std::ranges::transform(part.corners().first(count), plan.begin(), &Vec3::xy);
  const PlanShape shape({plan.data(), count});
  return shape.mayTouch(to) && shape.meetsBoth(level, from, to, cuts);
}

class MeshSpreader {
 public:
  explicit MeshSpreader(const Scene& scene) : scene_(scene) {}

  /// The sectors of a mesh, its own first. Valid until the next call.
  const std::vector<SectorId>& sectorsOf(const Mesh& mesh) {
    faces_ = scene_.level().facesOf(mesh);
    measure();
    sectors_.assign(1, mesh.sector);
    for (std::size_t i = 0; i < sectors_.size(); ++i) addNeighboursOf(scene_[sectors_[i]]);
    return sectors_;
  }

 private:
  void measure() {
    box_ = {};
    zBottom_ = std::numeric_limits<double>::infinity();
    zTop_ = -zBottom_;
    for (const MeshFace& face : faces_)
      for (const Vec3 corner : face.corners) {
        box_.add(corner.xy());
        zBottom_ = std::min(zBottom_, corner.z);
        zTop_ = std::max(zTop_, corner.z);
      }
    box_ = grown(box_, kPositionSlack);
    zBottom_ -= kPositionSlack;
    zTop_ += kPositionSlack;
  }

  void addNeighboursOf(const Sector& sector) {
    for (const Segment& segment : scene_.segmentsOf(sector))
      if (touch(box_, boxOf(segment.p0, segment.p1))) addBehind(segment);
    if (sector.floor.flatPortal) addAcross(sector, *sector.floor.flatPortal, FlatPortalSide::Lower);
    if (sector.ceiling.flatPortal)
      addAcross(sector, *sector.ceiling.flatPortal, FlatPortalSide::Upper);
  }

  void addBehind(const Segment& segment) {
    for (const WallPiece& piece : scene_.piecesOf(segment)) {
      const Opening* const opening = std::get_if<Opening>(&piece.content);
      if (opening && !isKnown(opening->next) && anyFace([&](const MeshFace& face) {
            return crosses(scene_, face, segment, piece, *opening);
          }))
        sectors_.push_back(opening->next);
    }
  }

  void addAcross(const Sector& sector, FlatPortalId id, FlatPortalSide to) {
    const FlatPortal& flatPortal = scene_[id];
    if (flatPortal.z < zBottom_ || flatPortal.z > zTop_) return;
    for (const SectorId other : flatPortal.members(to))
      if (!isKnown(other) && touch(box_, scene_[other].box) && anyFace([&](const MeshFace& face) {
            return crosses(scene_.level(), face, flatPortal.z, sector, scene_[other], cuts_);
          }))
        sectors_.push_back(other);
  }

  template <typename Test>
  bool anyFace(Test&& test) const {
    return std::ranges::any_of(faces_, test);
  }

  bool isKnown(SectorId sector) const {
    return std::ranges::find(sectors_, sector) != sectors_.end();
  }

  Scene scene_;
  std::span<const MeshFace> faces_;
  Box box_;
  double zBottom_ = 0;
  double zTop_ = 0;
  std::vector<SectorId> sectors_;
  std::vector<double> cuts_;
};

}  // namespace

std::optional<std::size_t> addMeshSectors(Level& level, const Geometry& geometry) {
  level.meshesBySector.clear();
  MeshSpreader spreader(Scene(level, geometry));
  for (std::size_t i = 0; i < level.meshes.size(); ++i) {
    for (const SectorId sector : spreader.sectorsOf(level.meshes[i]))
      level.meshesBySector.push_back({sector, static_cast<std::uint32_t>(i)});
    if (level.meshesBySector.size() > kMaxMeshesInSectors) return i;
  }
  std::ranges::stable_sort(level.meshesBySector, {}, &MeshInSector::sector);
  return std::nullopt;
}

}  // namespace hearth
