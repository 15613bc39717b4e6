#include "level/sprite_bodies.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "level/locate.h"
#include "level/scene.h"
#include "math/predicates.h"

namespace hearth {

namespace {

/// Follows openings from the sector of a body to all those that it reaches into.
class BodySpreader {
 public:
  explicit BodySpreader(const Scene& scene)
      : scene_(scene), reachedBy_(scene.level().sectors.size()) {}

  /// In the order in which they are found, until there are more than `limit`.
  const std::vector<SectorId>& sectorsOf(const Sprite& sprite, std::size_t limit) {
    ++bodies_;
    radius_ = sprite.body->radius;
    center_ = sprite.position.xy();
    zBottom_ = sprite.position.z;
    zTop_ = sprite.position.z + sprite.body->height;
    sectors_.clear();
    add(sprite.sector);
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
    for (const Segment& segment : scene_.segmentsOf(sector)) {
      const bool isInFront = cross(segment.p1 - segment.p0, center_ - segment.p0) >= 0;
      if (isInFront && reaches(segment)) visitWall(segment);
    }
    if (sector.floor.flatPortal && zBottom_ < scene_.zFloor(sector))
      visitFlat(scene_[*sector.floor.flatPortal], FlatPortalSide::Lower);
    if (sector.ceiling.flatPortal && zTop_ > scene_.zCeiling(sector))
      visitFlat(scene_[*sector.ceiling.flatPortal], FlatPortalSide::Upper);
  }

  void visitWall(const Segment& segment) {
    for (const WallPiece& piece : scene_.piecesOf(segment))
      if (const Opening* opening = std::get_if<Opening>(&piece.content))
        if (zBottom_ < piece.zTop && piece.zBottom < zTop_) add(opening->next);
  }

  void visitFlat(const FlatPortal& flatPortal, FlatPortalSide to) {
    for (const SectorId member : flatPortal.members(to))
      if (reaches(scene_[member])) add(member);
  }

  bool reaches(const Segment& segment) const {
    return length(nearestOnSegment(segment.p0, segment.p1, center_) - center_) < radius_;
  }

  bool reaches(const Sector& sector) const {
    if (!grown(sector.box, radius_).contains(center_)) return false;
    return contains(scene_.level(), sector, center_) ||
           std::ranges::any_of(scene_.segmentsOf(sector),
                               [&](const Segment& segment) { return reaches(segment); });
  }

  Scene scene_;
  std::vector<std::size_t> reachedBy_;  // by SectorId: the number of the last body that does
  std::size_t bodies_ = 0;
  std::vector<SectorId> sectors_;
  Vec2 center_;
  double radius_ = 0;
  double zBottom_ = 0;
  double zTop_ = 0;
};

}  // namespace

std::optional<std::size_t> addBodies(Level& level, const Geometry& geometry) {
  level.bodies.clear();
  BodySpreader spreader(Scene(level, geometry));
  for (std::size_t i = 0; i < level.sprites.size(); ++i) {
    if (!level.sprites[i].body) continue;
    for (const SectorId sector :
         spreader.sectorsOf(level.sprites[i], kMaxBodies - level.bodies.size()))
      level.bodies.push_back({sector, static_cast<std::uint32_t>(i)});
    if (level.bodies.size() > kMaxBodies) return i;
  }
  std::ranges::stable_sort(level.bodies, {}, &BodyInSector::sector);
  return std::nullopt;
}

}  // namespace hearth
