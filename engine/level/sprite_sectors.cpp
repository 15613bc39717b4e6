#include "level/sprite_sectors.h"

#include <algorithm>
#include <array>
#include <variant>

#include "level/openings.h"
#include "level/plan_shape.h"
#include "math/line_part.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// What a sprite's image covers of the map, and its heights.
class Footprint {
 public:
  explicit Footprint(const SpriteRect& rect)
      : plan_(cornersOf(rect)), zBottom_(rect.corner.z), zTop_(rect.corner.z + rect.up.z) {}

  const PlanShape& plan() const { return plan_; }

  bool reaches(double zBottom, double zTop) const {
    return zTop >= zBottom_ - kPositionSlack && zBottom <= zTop_ + kPositionSlack;
  }

 private:
  static std::array<Vec2, 4> cornersOf(const SpriteRect& rect) {
    const Vec2 corner = rect.corner.xy();
    const Vec2 right = rect.right.xy();
    const Vec2 up = rect.up.xy();
    return {corner, corner + right, corner + right + up, corner + up};
  }

  PlanShape plan_;
  double zBottom_;
  double zTop_;
};

class SectorFinder {
 public:
  SectorFinder(const Scene& scene, const Footprint& footprint, std::vector<SectorId>& sectors,
               std::vector<double>& cuts)
      : scene_(scene), footprint_(footprint), sectors_(sectors), cuts_(cuts) {}

  void findFrom(SectorId first) {
    sectors_.assign(1, first);
    for (std::size_t i = 0; i < sectors_.size(); ++i) addNeighboursOf(scene_[sectors_[i]]);
  }

 private:
  void addNeighboursOf(const Sector& sector) {
    for (const Segment& segment : scene_.segmentsOf(sector))
      if (const auto part = footprint_.plan().partOf(segment)) addBehind(segment, *part);
    if (sector.floor.flatPortal) addAcross(sector, *sector.floor.flatPortal, FlatPortalSide::Lower);
    if (sector.ceiling.flatPortal)
      addAcross(sector, *sector.ceiling.flatPortal, FlatPortalSide::Upper);
  }

  /// Heights of openings change evenly along a segment, or with one bend.
  void addBehind(const Segment& segment, LinePart part) {
    for (const double fraction : {part.from, (part.from + part.to) / 2, part.to})
      for (const WallPiece& piece : scene_.piecesOf(segment)) {
        const Opening* const opening = std::get_if<Opening>(&piece.content);
        if (!opening || isKnown(opening->next)) continue;
        const OpeningSpan span = openingSpan(piece, scene_.airAt(segment, fraction),
                                             scene_.airAt(scene_[opening->twin], 1 - fraction));
        if (span.zTop - span.zBottom > kPositionSlack &&
            footprint_.reaches(span.zBottom, span.zTop))
          sectors_.push_back(opening->next);
      }
  }

  void addAcross(const Sector& sector, FlatPortalId id, FlatPortalSide to) {
    const FlatPortal& flatPortal = scene_[id];
    if (!footprint_.reaches(flatPortal.z, flatPortal.z)) return;
    for (const SectorId other : flatPortal.members(to))
      if (!isKnown(other) && footprint_.plan().mayTouch(scene_[other]) &&
          footprint_.plan().meetsBoth(scene_.level(), sector, scene_[other], cuts_))
        sectors_.push_back(other);
  }

  bool isKnown(SectorId sector) const {
    return std::ranges::find(sectors_, sector) != sectors_.end();
  }

  Scene scene_;
  const Footprint& footprint_;
  std::vector<SectorId>& sectors_;
  std::vector<double>& cuts_;
};

}  // namespace

const std::vector<SectorId>& SpriteSectors::find(const Scene& scene, const Sprite& sprite,
                                                 const SpriteRect& rect) {
  SectorFinder(scene, Footprint(rect), sectors_, cuts_).findFrom(sprite.sector);
  return sectors_;
}

}  // namespace hearth
