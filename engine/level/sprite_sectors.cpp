#include "level/sprite_sectors.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "level/locate.h"
#include "level/openings.h"
#include "math/box.h"
#include "math/line_part.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Metres to either side of a line: more than a touch.
constexpr double kBeside = 4 * kPositionSlack;

/// What a sprite's image covers of the map, a rectangle, and its heights. The rectangle of what
/// stands is a line.
class Footprint {
 public:
  explicit Footprint(const SpriteRect& rect)
      : corner_(rect.corner.xy()),
        width_(length(rect.right)),
        across_((1 / width_) * rect.right.xy()),
        depth_(length(rect.up.xy())),
        along_(depth_ > 0 ? (1 / depth_) * rect.up.xy() : turned90(across_)),
        zBottom_(rect.corner.z),
        zTop_(rect.corner.z + rect.up.z) {
    for (const Vec2 p :
         {corner_, at(width_), at(width_) + depth_ * along_, corner_ + depth_ * along_})
      box_.add(p);
  }

  bool mayTouch(const Sector& sector) const {
    return touch(grown(box_, kPositionSlack), sector.box);
  }

  /// The part of a segment that it covers.
  std::optional<LinePart> partOf(const Segment& segment) const {
    const std::optional<LinePart> part = partBetweenEdges(across_, width_, segment, {});
    return part ? partBetweenEdges(along_, depth_, segment, *part) : std::nullopt;
  }

  bool reaches(double zBottom, double zTop) const {
    return zTop >= zBottom_ - kPositionSlack && zBottom <= zTop_ + kPositionSlack;
  }

  /// Whether it covers a point that two sectors have in common, a common edge apart. Looks beside
  /// each line on which outlines may bound what is common: on the edges of the rectangle, and on
  /// those of the outlines inside. Uses `cuts` as memory.
  bool meetsBoth(const Level& level, const Sector& a, const Sector& b,
                 std::vector<double>& cuts) const {
    const auto meetBeside = [&](Vec2 from, Vec2 to) {
      return hasPointBeside(level, a, b, from, to, cuts);
    };
    const Vec2 right = at(width_);
    if (depth_ == 0) return meetBeside(corner_, right);
    const Vec2 up = depth_ * along_;
    if (meetBeside(corner_, right) || meetBeside(right, right + up) ||
        meetBeside(right + up, corner_ + up) || meetBeside(corner_ + up, corner_))
      return true;
    const auto meetsBesideOutline = [&](const Sector& sector) {
      return std::ranges::any_of(level.segmentsOf(sector), [&](const Segment& segment) {
        const auto part = partOf(segment);
        return part && meetBeside(lerp(segment.p0, segment.p1, part->from),
                                  lerp(segment.p0, segment.p1, part->to));
      });
    };
    return meetsBesideOutline(a) || meetsBesideOutline(b);
  }

 private:
  Vec2 at(double across) const { return corner_ + across * across_; }

  /// No more than kPositionSlack outside the two edges across an axis.
  std::optional<LinePart> partBetweenEdges(Vec2 axis, double size, const Segment& segment,
                                           LinePart part) const {
    const double first = dot(segment.p0 - corner_, axis) + kPositionSlack;
    const double second = dot(segment.p1 - corner_, axis) + kPositionSlack;
    const std::optional<LinePart> kept = keepPositive(part, first, second);
    const double end = size + 2 * kPositionSlack;
    return kept ? keepPositive(*kept, end - first, end - second) : std::nullopt;
  }

  bool covers(Vec2 p) const {
    constexpr double kSlack = 2 * kBeside;
    const double across = dot(p - corner_, across_);
    const double along = dot(p - corner_, along_);
    return across >= -kSlack && across <= width_ + kSlack && along >= -kSlack &&
           along <= depth_ + kSlack;
  }

  /// Whether both sectors have air on one side of a line in the rectangle. Between two places where
  /// an outline cuts the line that is so everywhere or nowhere.
  bool hasPointBeside(const Level& level, const Sector& a, const Sector& b, Vec2 from, Vec2 to,
                      std::vector<double>& cuts) const {
    const Vec2 line = to - from;
    cuts.assign({0, 1});
    for (const Sector* sector : {&a, &b})
      for (const Segment& segment : level.segmentsOf(*sector)) {
        const double speed = cross(line, segment.p1 - segment.p0);
        const double cut = cross(segment.p0 - from, segment.p1 - segment.p0) / speed;
        if (cut > 0 && cut < 1) cuts.push_back(cut);
      }
    std::ranges::sort(cuts);
    const double size = length(line);
    const Vec2 aside = size > 0 ? (kBeside / size) * turned90(line) : Vec2{kBeside, 0};
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if (size * (cuts[i] - cuts[i - 1]) < kBeside) continue;
      const Vec2 middle = lerp(from, to, (cuts[i - 1] + cuts[i]) / 2);
      for (const Vec2 p : {middle + aside, middle - aside})
        if (covers(p) && contains(level, a, p) && contains(level, b, p)) return true;
    }
    return false;
  }

  Vec2 corner_;
  double width_;
  Vec2 across_;
  double depth_;
  Vec2 along_;
  double zBottom_;
  double zTop_;
  Box box_;
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
      if (const auto part = footprint_.partOf(segment)) addBehind(segment, *part);
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
      if (!isKnown(other) && footprint_.mayTouch(scene_[other]) &&
          footprint_.meetsBoth(scene_.level(), sector, scene_[other], cuts_))
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
