#include "level/thing_bodies.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "level/locate.h"
#include "level/scene.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

ThingBody cylinderOf(const Sprite& sprite) {
  ThingBody body{ConvexOutline({sprite.position.xy()}), sprite.body->radius};
  stand(body, sprite);
  return body;
}

ThingBody prismOf(const Level& level, const Mesh& mesh) {
  std::vector<Vec2> plan;
  plan.reserve(3 * std::size_t{mesh.faceCount});
  double zBottom = std::numeric_limits<double>::infinity();
  double zTop = -zBottom;
  for (const MeshFace& face : level.facesOf(mesh))
    for (const Vec3 corner : face.corners) {
      plan.push_back(corner.xy());
      zBottom = std::min(zBottom, corner.z);
      zTop = std::max(zTop, corner.z);
    }
  return {ConvexOutline(std::move(plan)), 0, zBottom, zTop};
}

/// Follows openings from the sector of a body to all those that it reaches into.
class BodySpreader {
 public:
  explicit BodySpreader(const Scene& scene)
      : scene_(scene), reachedBy_(scene.level().sectors.size()) {}

  /// Those of the body of a thing in `first` at `center`, in the order in which they are found,
  /// until there are more than `limit`. Valid until the next call.
  const std::vector<SectorId>& sectorsOf(const ThingBody& body, SectorId first, Vec2 center,
                                         std::size_t limit) {
    ++bodies_;
    body_ = &body;
    center_ = center;
    sectors_.clear();
    add(first);
    for (std::size_t i = 0; i < sectors_.size() && sectors_.size() <= limit; ++i)
      visit(scene_[sectors_[i]]);
    return sectors_;
  }

 private:
  void add(SectorId sector) {
    if (reachedBy_[sector.index()] == bodies_) return;
    reachedBy_[sector.index()] = bodies_;
    sectors_.push_back(sector);
  }

  void visit(const Sector& sector) {
    for (const Segment& segment : scene_.segmentsOf(sector))
      if (faces(segment, center_) && reaches(segment)) visitWall(segment);
    if (sector.floor.flatPortal && body_->zBottom <= scene_.zFloor(sector) + kPositionSlack)
      visitFlat(scene_[*sector.floor.flatPortal], FlatPortalSide::Lower);
    if (sector.ceiling.flatPortal && body_->zTop >= scene_.zCeiling(sector) - kPositionSlack)
      visitFlat(scene_[*sector.ceiling.flatPortal], FlatPortalSide::Upper);
  }

  void visitWall(const Segment& segment) {
    for (const WallPiece& piece : scene_.piecesOf(segment))
      if (const Opening* opening = std::get_if<Opening>(&piece.content))
        if (body_->zBottom <= piece.zTop + kPositionSlack &&
            body_->zTop >= piece.zBottom - kPositionSlack)
          add(opening->next);
  }

  void visitFlat(const FlatPortal& flatPortal, FlatPortalSide to) {
    for (const SectorId member : flatPortal.members(to))
      if (reaches(scene_[member])) add(member);
  }

  static bool faces(const Segment& segment, Vec2 p) {
    return cross(segment.p1 - segment.p0, p - segment.p0) >= -kPositionSlack * segment.length;
  }

  double reach() const { return body_->radius + kPositionSlack; }

  bool reaches(const Segment& segment) const {
    return body_->outline.isWithin(segment.p0, segment.p1, reach());
  }

  bool reaches(const Sector& sector) const {
    if (!touch(grown(sector.box, reach()), body_->outline.box())) return false;
    return contains(scene_.level(), sector, body_->outline.corners().front()) ||
           std::ranges::any_of(scene_.segmentsOf(sector),
                               [&](const Segment& segment) { return reaches(segment); });
  }

  Scene scene_;
  std::vector<std::size_t> reachedBy_;  // by SectorId: the number of the last body that does
  std::size_t bodies_ = 0;
  std::vector<SectorId> sectors_;
  const ThingBody* body_ = nullptr;
  Vec2 center_;
};

}  // namespace

void stand(ThingBody& body, const Sprite& sprite) {
  body.zBottom = sprite.position.z;
  body.zTop = sprite.position.z + sprite.body->height;
}

std::optional<std::uint32_t> addBodies(Level& level, const Geometry& geometry) {
  level.bodies.clear();
  level.bodiesBySector.clear();
  BodySpreader spreader(Scene(level, geometry));
  const auto add = [&](ThingBody body, const auto& thing) {
    const auto index = static_cast<std::uint32_t>(level.bodies.size());
    for (const SectorId sector : spreader.sectorsOf(body, thing.sector, thing.position.xy(),
                                                    kMaxBodies - level.bodiesBySector.size()))
      level.bodiesBySector.push_back({sector, index});
    level.bodies.push_back(std::move(body));
    return level.bodiesBySector.size() <= kMaxBodies;
  };
  for (const Sprite& sprite : level.sprites)
    if (sprite.body && !add(cylinderOf(sprite), sprite)) return sprite.thing;
  for (const Mesh& mesh : level.meshes)
    if (mesh.isSolid && !add(prismOf(level, mesh), mesh)) return mesh.thing;
  std::ranges::stable_sort(level.bodiesBySector, {}, &BodyInSector::sector);
  return std::nullopt;
}

}  // namespace hearth
