#include "walk/passage.h"

#include <algorithm>
#include <cmath>

#include "walk/body.h"

namespace hearth {

namespace {

const Opening& openingAt(const Scene& scene, const Segment& segment, std::size_t piece) {
  return std::get<Opening>(scene.piecesOf(segment)[piece].content);
}

/// Whether two pieces that meet let a body be in both at once: no floor or ceiling parts them.
bool areJoined(const Scene& scene, const Segment& segment, std::size_t lower, std::size_t upper) {
  const WallPiece& below = scene.piecesOf(segment)[lower];
  const WallPiece& above = scene.piecesOf(segment)[upper];
  if (!std::holds_alternative<Opening>(above.content) || below.zTop != above.zBottom) return false;
  const SectorId nextBelow = openingAt(scene, segment, lower).next;
  const SectorId nextAbove = openingAt(scene, segment, upper).next;
  if (nextBelow == nextAbove) return true;
  const auto& ceiling = scene[nextBelow].ceiling.flatPortal;
  return ceiling && ceiling == scene[nextAbove].floor.flatPortal;
}

/// Where along a line from `at0` to `at1` it is at most `limit`.
Interval whereAtMost(double at0, double at1, double limit) {
  if (at0 <= limit && at1 <= limit) return {0, 1};
  if (at0 > limit && at1 > limit) return {1, 0};
  const double fraction = (limit - at0) / (at1 - at0);
  return at0 <= limit ? Interval{0, fraction} : Interval{fraction, 1};
}

}  // namespace

Interval intersection(Interval a, Interval b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

Interval chordOf(Vec2 a, Vec2 b, double radius) {
  const Vec2 along = b - a;
  const double size = length(along);
  if (size == 0) return {1, 0};
  const double distance = cross(along, a) / size;
  const double halfSquared = (radius - distance) * (radius + distance);
  if (!(halfSquared > 0)) return {1, 0};
  const double middle = -dot(a, along) / (size * size);
  const double half = std::sqrt(halfSquared) / size;
  return intersection(Interval{0, 1}, Interval{middle - half, middle + half});
}

Passage::Passage(const Scene& scene, const Segment& segment, std::size_t first, std::size_t last)
    : first_(first), last_(last) {
  const Sector& sector = scene[segment.sector];
  const auto line = [](double z) { return Line{z, z}; };

  const WallPiece& lowest = scene.piecesOf(segment)[first];
  const Opening& below = openingAt(scene, segment, first);
  const Sector& nextBelow = scene[below.next];
  const bool isOpenBelow = sector.floor.flatPortal && lowest.zBottom <= scene.zFloor(sector) &&
                           (nextBelow.floor.flatPortal || scene.zFloor(nextBelow) < lowest.zBottom);
  bottoms_ = {{line(-kInfinity), line(-kInfinity), line(-kInfinity)}};
  if (!isOpenBelow) {
    const Segment& far = scene[below.twin];
    bottoms_ = {{line(lowest.zBottom),
                 {scene.geometryOf(segment).air0.zBottom, scene.geometryOf(segment).air1.zBottom},
                 {scene.geometryOf(far).air1.zBottom, scene.geometryOf(far).air0.zBottom}}};
  }

  const WallPiece& highest = scene.piecesOf(segment)[last];
  const Opening& above = openingAt(scene, segment, last);
  const Sector& nextAbove = scene[above.next];
  const bool isOpenAbove =
      sector.ceiling.flatPortal && highest.zTop >= scene.zCeiling(sector) &&
      (nextAbove.ceiling.flatPortal || scene.zCeiling(nextAbove) > highest.zTop);
  tops_ = {{line(kInfinity), line(kInfinity), line(kInfinity)}};
  if (!isOpenAbove) {
    const Segment& far = scene[above.twin];
    tops_ = {{line(highest.zTop),
              {scene.geometryOf(segment).air0.zTop, scene.geometryOf(segment).air1.zTop},
              {scene.geometryOf(far).air1.zTop, scene.geometryOf(far).air0.zTop}}};
  }
}

Interval Passage::openTo(const UprightBody& body) const {
  Interval open{0, 1};
  for (const Line& bottom : bottoms_.lines)
    open = intersection(open, whereAtMost(bottom.at0, bottom.at1, body.zClimb + kSkin));
  for (const Line& top : tops_.lines)
    open = intersection(open, whereAtMost(-top.at0, -top.at1, -body.zHead() + kSkin));
  for (const Line& bottom : bottoms_.lines)
    for (const Line& top : tops_.lines)
      open = intersection(
          open, whereAtMost(bottom.at0 - top.at0, bottom.at1 - top.at1, -body.height + kSkin));
  return open;
}

double Passage::zBottom(Interval within) const {
  double z = -kInfinity;
  for (const Line& line : bottoms_.lines)
    if (line.at0 > -kInfinity)
      for (const double fraction : {within.low, within.high})
        z = std::max(z, std::lerp(line.at0, line.at1, fraction));
  return z;
}

double Passage::zTop(Interval within) const {
  double z = kInfinity;
  for (const Line& line : tops_.lines)
    if (line.at0 < kInfinity)
      for (const double fraction : {within.low, within.high})
        z = std::min(z, std::lerp(line.at0, line.at1, fraction));
  return z;
}

void findPassages(const Scene& scene, const Segment& segment, std::pmr::vector<Passage>& passages) {
  for (std::size_t first = 0; first < scene.piecesOf(segment).size(); ++first) {
    if (!std::holds_alternative<Opening>(scene.piecesOf(segment)[first].content)) continue;
    std::size_t last = first;
    while (last + 1 < scene.piecesOf(segment).size() && areJoined(scene, segment, last, last + 1))
      ++last;
    passages.emplace_back(scene, segment, first, last);
    first = last;
  }
}

}  // namespace hearth
