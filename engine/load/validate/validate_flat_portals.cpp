#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "load/link/link.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// A directed piece of an outline, comparable to the bit.
using Piece = std::tuple<double, double, double, double>;

Piece pieceOf(const Segment& segment) {
  return {segment.p0.x, segment.p0.y, segment.p1.x, segment.p1.y};
}
Piece reversed(const Piece& piece) {
  const auto& [x0, y0, x1, y1] = piece;
  return {x1, y1, x0, y0};
}

/// The outlines of the sectors on one side of a flat portal. Welding has cut those of both sides
/// into the same pieces wherever they run along each other.
class SideOutline {
 public:
  SideOutline(const Level& level, const std::vector<SectorId>& members)
      : segments_(segmentsOf(level, members)), tree_(boxesOf(segments_)) {
    for (const Segment* segment : segments_) ++count_[pieceOf(*segment)];
  }

  /// A place where two members overlap.
  std::optional<Vec2> findOverlap() const {
    for (const Segment* segment : segments_) {
      if (count_.at(pieceOf(*segment)) > 1) return lerp(segment->p0, segment->p1, 0.5);
      if (crossesAnother(*segment)) return lerp(segment->p0, segment->p1, 0.5);
      if (liesInAnother(*segment)) return lerp(segment->p0, segment->p1, 0.5);
    }
    return std::nullopt;
  }

  /// A piece of this side's outer outline that is none of the other's.
  std::optional<Vec2> findDifference(const SideOutline& other) const {
    for (const Segment* segment : segments_) {
      const Piece piece = pieceOf(*segment);
      const bool isInner = count_.contains(reversed(piece));
      const bool isInnerThere =
          other.count_.contains(piece) && other.count_.contains(reversed(piece));
      if (!isInner && (!other.count_.contains(piece) || isInnerThere))
        return lerp(segment->p0, segment->p1, 0.5);
    }
    return std::nullopt;
  }

 private:
  static std::vector<const Segment*> segmentsOf(const Level& level,
                                                const std::vector<SectorId>& members) {
    std::vector<const Segment*> segments;
    for (const SectorId member : members)
      for (const Segment& segment : level.segmentsOf(level[member])) segments.push_back(&segment);
    return segments;
  }

  static BoxTree boxesOf(const std::vector<const Segment*>& segments) {
    std::vector<Box> boxes;
    for (const Segment* segment : segments) boxes.push_back(boxOf(segment->p0, segment->p1));
    return BoxTree(boxes);
  }

  bool crossesAnother(const Segment& a) const {
    bool found = false;
    tree_.query(boxOf(a.p0, a.p1), [&](std::uint32_t i) {
      const Segment& b = *segments_[i];
      if (b.sector == a.sector) return;
      if (orientation(a.p0, a.p1, b.p0) * orientation(a.p0, a.p1, b.p1) >= 0) return;
      if (orientation(b.p0, b.p1, a.p0) * orientation(b.p0, b.p1, a.p1) >= 0) return;
      const double noise = noiseOf(std::min(length(a.p1 - a.p0), length(b.p1 - b.p0)));
      const auto isApart = [&](const Segment& s, Vec2 p) {
        return length(nearestOnSegment(s.p0, s.p1, p) - p) > noise;
      };
      found |= isApart(a, b.p0) && isApart(a, b.p1) && isApart(b, a.p0) && isApart(b, a.p1);
    });
    return found;
  }

  /// Whether the middle of a piece lies inside another member, and not on its outline.
  bool liesInAnother(const Segment& segment) const {
    const Vec2 p = lerp(segment.p0, segment.p1, 0.5);
    std::map<SectorId, bool> isInside;
    tree_.query({p, {kEndless, p.y}}, [&](std::uint32_t i) {
      const Segment& wall = *segments_[i];
      if (wall.sector == segment.sector || (wall.p0.y <= p.y) == (wall.p1.y <= p.y)) return;
      if ((orientation(wall.p0, wall.p1, p) > 0) == (wall.p1.y > p.y))
        isInside[wall.sector] ^= true;
    });
    // On an outline rounding says which side it is on.
    tree_.query(grown({p, p}, kAuthorNoise), [&](std::uint32_t i) {
      const Segment& wall = *segments_[i];
      const double noise =
          noiseOf(std::min(length(segment.p1 - segment.p0), length(wall.p1 - wall.p0)));
      if (length(nearestOnSegment(wall.p0, wall.p1, p) - p) <= noise) isInside.erase(wall.sector);
    });
    return std::any_of(isInside.begin(), isInside.end(),
                       [](const auto& entry) { return entry.second; });
  }

  static constexpr double kEndless = std::numeric_limits<double>::infinity();

  std::vector<const Segment*> segments_;
  BoxTree tree_;
  std::map<Piece, int> count_;
};

/// Where a flat portal is first named.
const FlatPortalDescription& describedNext(const Linking& linking, const FlatPortal& flatPortal) {
  const bool isFloor = !flatPortal.upper.empty();
  const SectorId member = isFloor ? flatPortal.upper.front() : flatPortal.lower.front();
  const SectorDescription& sector = linking.description.sectors[member.index()];
  return isFloor ? *sector.floor.next : *sector.ceiling.next;
}

bool isSound(const Linking& linking, const FlatPortal& flatPortal) {
  const auto hasSoundOutline = [&](SectorId member) {
    return linking.outlines.sectors[member.index()].isSound;
  };
  return !flatPortal.upper.empty() && !flatPortal.lower.empty() &&
         std::all_of(flatPortal.upper.begin(), flatPortal.upper.end(), hasSoundOutline) &&
         std::all_of(flatPortal.lower.begin(), flatPortal.lower.end(), hasSoundOutline);
}

void validateFlatPortal(Linking& linking, const FlatPortal& flatPortal) {
  const SideOutline upper(linking.level, flatPortal.upper);
  const SideOutline lower(linking.level, flatPortal.lower);
  const Place place = describedNext(linking, flatPortal).place;
  for (const bool isUpper : {true, false}) {
    const std::optional<Vec2> overlap = (isUpper ? upper : lower).findOverlap();
    if (!overlap) continue;
    linking.report.error(
        place,
        fmt::format("sectors {} the flat portal \"{}\" overlap near ({}, {})",
                    isUpper ? "above" : "below", flatPortal.name, overlap->x, overlap->y),
        "let them share walls only");
    return;
  }
  std::optional<Vec2> difference = upper.findDifference(lower);
  if (!difference) difference = lower.findDifference(upper);
  if (difference)
    linking.report.error(
        place,
        fmt::format("the sectors above and below the flat portal \"{}\" cover different areas near"
                    " ({}, {})",
                    flatPortal.name, difference->x, difference->y),
        "let both sides cover the same area, to within 1 mm");
}

}  // namespace

void validateFlatPortals(Linking& linking) {
  for (const FlatPortal& flatPortal : linking.level.flatPortals)
    if (isSound(linking, flatPortal)) validateFlatPortal(linking, flatPortal);
}

}  // namespace hearth
