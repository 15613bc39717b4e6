#include "level/plan_shape.h"

#include <algorithm>

#include "level/locate.h"
#include "math/check.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth {

namespace {

/// Metres to either side of a line: more than a touch.
constexpr double kBeside = 4 * kPositionSlack;

/// The ends of the longest line between two corners.
std::array<Vec2, 2> farthestCorners(std::span<const Vec2> corners) {
  std::array<Vec2, 2> ends{corners.front(), corners.front()};
  for (const Vec2 a : corners)
    for (const Vec2 b : corners)
      if (length(b - a) > length(ends[1] - ends[0])) ends = {a, b};
  return ends;
}

bool areInLine(std::span<const Vec2> corners, Vec2 from, Vec2 to) {
  const double size = length(to - from);
  return size <= kPositionSlack || std::ranges::all_of(corners, [&](Vec2 p) {
           return std::abs(cross(to - from, p - from)) <= kPositionSlack * size;
         });
}

/// Positive where the corners go clockwise on the map.
double turnOf(std::span<const Vec2> corners) {
  double turn = 0;
  for (std::size_t i = 2; i < corners.size(); ++i)
    turn += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return turn;
}

}  // namespace

PlanShape::PlanShape(std::span<const Vec2> corners) {
  CHECK(!corners.empty() && corners.size() <= kMaxCorners, corners.size());
  for (const Vec2 corner : corners) box_.add(corner);
  const auto [from, to] = farthestCorners(corners);
  if (areInLine(corners, from, to))
    makeLine(from, to);
  else
    makePolygon(corners);
}

void PlanShape::makeLine(Vec2 from, Vec2 to) {
  const Vec2 along = from == to ? Vec2{1, 0} : unit(to - from);
  addSide(from, along);
  addSide(to, -1 * along);
  addSide(from, turned90(along));
  addSide(from, -1 * turned90(along));
  addBorder(from, to);
}

void PlanShape::makePolygon(std::span<const Vec2> corners) {
  const double clockwise = turnOf(corners) > 0 ? 1 : -1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 from = corners[i];
    const Vec2 to = corners[(i + 1) % corners.size()];
    if (from == to) continue;
    addSide(from, clockwise * turned90(unit(to - from)));
    addBorder(from, to);
  }
}

bool PlanShape::mayTouch(const Sector& sector) const {
  return touch(grown(box_, kPositionSlack), sector.box);
}

std::optional<LinePart> PlanShape::partOf(const Segment& segment) const {
  std::optional<LinePart> part{LinePart{}};
  for (const Side& side : sides()) {
    part = keepPositive(*part, side.distance(segment.p0) + kPositionSlack,
                        side.distance(segment.p1) + kPositionSlack);
    if (!part) break;
  }
  return part;
}

/// Whether two sectors have air in common beside a point that is on an outline. Looks in no
/// direction in which walls tend to run.
bool haveAirBeside(const Level& level, const Sector& a, const Sector& b, Vec2 p) {
  constexpr int kDirections = 64;
  for (int i = 0; i < kDirections; ++i) {
    const SinCos turn = sinCosDegrees(360 * (i + 0.5) / kDirections);
    const Vec2 beside = p + kBeside * Vec2{turn.cos, turn.sin};
    if (contains(level, a, beside) && contains(level, b, beside)) return true;
  }
  return false;
}

bool isOnOutline(const Level& level, const Sector& sector, Vec2 p) {
  return std::ranges::any_of(level.segmentsOf(sector), [&](const Segment& segment) {
    return length(p - nearestOnSegment(segment.p0, segment.p1, p)) <= kPositionSlack;
  });
}

/// Looks beside each line on which outlines may bound what is common: on its own borders, and on
/// the outlines inside.
bool PlanShape::meetsBoth(const Level& level, const Sector& a, const Sector& b,
                          std::vector<double>& cuts) const {
  const auto meetBeside = [&](Border line) { return hasPointBeside(level, a, b, line, cuts); };
  if (std::ranges::any_of(borders(), meetBeside) || touchesCorner(level, a, b)) return true;
  if (borderCount_ == 1) return false;
  const auto meetsBesideOutline = [&](const Sector& sector) {
    return std::ranges::any_of(level.segmentsOf(sector), [&](const Segment& segment) {
      const auto part = partOf(segment);
      return part && meetBeside({lerp(segment.p0, segment.p1, part->from),
                                 lerp(segment.p0, segment.p1, part->to)});
    });
  };
  return meetsBesideOutline(a) || meetsBesideOutline(b);
}

/// Whether a corner of one of the outlines lies in it, or a corner of its own where the sectors
/// have air in common: it may reach no farther into that, or be a point.
bool PlanShape::touchesCorner(const Level& level, const Sector& a, const Sector& b) const {
  for (const Sector* sector : {&a, &b})
    for (const Segment& segment : level.segmentsOf(*sector))
      if (covers(segment.p0, kPositionSlack) && haveAirBeside(level, a, b, segment.p0)) return true;
  const auto touchesAt = [&](Vec2 corner) {
    const auto touches = [&](const Sector& sector) {
      return contains(level, sector, corner) || isOnOutline(level, sector, corner);
    };
    return touches(a) && touches(b) && haveAirBeside(level, a, b, corner);
  };
  return std::ranges::any_of(
      borders(), [&](const Border& line) { return touchesAt(line.from) || touchesAt(line.to); });
}

bool PlanShape::covers(Vec2 p, double slack) const {
  return std::ranges::all_of(sides(), [&](const Side& side) { return side.distance(p) >= -slack; });
}

/// Whether both sectors have air on one side of a line. Between two places where an outline cuts
/// the line that is so everywhere or nowhere.
bool PlanShape::hasPointBeside(const Level& level, const Sector& a, const Sector& b, Border line,
                               std::vector<double>& cuts) const {
  const Vec2 way = line.to - line.from;
  cuts.assign({0, 1});
  for (const Sector* sector : {&a, &b})
    for (const Segment& segment : level.segmentsOf(*sector)) {
      const double speed = cross(way, segment.p1 - segment.p0);
      const double cut = cross(segment.p0 - line.from, segment.p1 - segment.p0) / speed;
      if (cut > 0 && cut < 1) cuts.push_back(cut);
    }
  std::ranges::sort(cuts);
  const double size = length(way);
  const Vec2 aside = size > 0 ? (kBeside / size) * turned90(way) : Vec2{kBeside, 0};
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (size * (cuts[i] - cuts[i - 1]) < kBeside) continue;
    const Vec2 middle = lerp(line.from, line.to, (cuts[i - 1] + cuts[i]) / 2);
    for (const Vec2 p : {middle + aside, middle - aside})
      if (covers(p, 2 * kBeside) && contains(level, a, p) && contains(level, b, p)) return true;
  }
  return false;
}

}  // namespace hearth
