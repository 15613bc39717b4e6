#include "walk/surroundings.h"

#include <algorithm>
#include <cmath>

#include "level/walls_in.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

double signedDistance(Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  return cross(along, Vec2{} - a) / length(along);
}

bool isInFrontOf(const Segment& segment, Vec2 p) {
  return cross(segment.p1 - segment.p0, p - segment.p0) >= 0;
}

/// A flat, or the slope that replaces it.
struct PlaneAt {
  double z;
  Vec2 gradient;
};

PlaneAt planeAt(double zFlat, const std::optional<Slope>& slope, Vec2 p) {
  if (slope) return {slope->zAt(p), slope->gradient};
  return {zFlat, {0, 0}};
}

}  // namespace

Surroundings::Surroundings(const Scene& scene, SectorId from, const SweepQuery& query)
    : scene_(scene), query_(query), sweptRadius_(query.radius + query.travel) {
  add(from);
  for (std::size_t i = 0; i < sectors_.size(); ++i) visitSector(scene_[sectors_[i]]);
  for (const SectorId sector : sectors_)
    for (const BodyInSector& at : scene_.level().bodiesIn(sector)) visitBody(at.body);
}

void Surroundings::add(SectorId sector) {
  if (std::ranges::find(sectors_, sector) == sectors_.end()) sectors_.push_back(sector);
}

void Surroundings::visitSector(const Sector& sector) {
  forEachWallInReach(sector, [&](const Segment& segment) { visitWall(segment); });
  forEachWallInReach(sector, [&](const Segment& segment) {
    const Loop& loop = sector.loops[segment.loop];
    const std::size_t before =
        (segment.id == loop.first ? segment.id.index() + loop.count : segment.id.index()) - 1;
    visitVertex(scene_.level().segments[before], segment);
  });
  addFlats(sector);
  if (sector.floorSlope || sector.ceilingSlope) addSlopes(sector);
}

/// Calls `visit(segment)` for all walls within reach, and for some others.
template <typename Visit>
void Surroundings::forEachWallInReach(const Sector& sector, Visit&& visit) const {
  forEachWallIn(scene_.level(), sector, boxAround(query_.center, sweptRadius_), visit);
}

void Surroundings::visitWall(const Segment& segment) {
  const Vec2 a = segment.p0 - query_.center;
  const Vec2 b = segment.p1 - query_.center;
  const Interval chord = chordOf(a, b, sweptRadius_);
  if (chord.isEmpty() || signedDistance(a, b) < -query_.travel - kSkin) return;
  passages_.clear();
  open_.clear();
  findPassages(scene_, segment, passages_);
  const Sector& sector = scene_[segment.sector];
  if (isBelow(sector)) return visitWallBelow(segment, chord);
  if (isAbove(sector)) return visitWallAbove(segment, chord);

  for (const Passage& passage : passages_) {
    const Interval open = passage.openTo(query_.body);
    if (open.isEmpty()) continue;
    open_.push_back(open);
    const Interval reached = intersection(open, chord);
    if (reached.isEmpty()) continue;
    addSupport(passage.zBottom(reached));
    zCap_ = std::min(zCap_, passage.zTop(reached));
    for (std::size_t i = passage.first(); i <= passage.last(); ++i)
      add(std::get<Opening>(scene_.piecesOf(segment)[i].content).next);
  }
  block(segment, chord);
}

/// Where only one of two walls stops the body, it may see the vertex between them from round the
/// corner, behind that wall: past the other one, which is open. From behind both walls the vertex
/// is not seen: there it may be a joint of one-way portals.
void Surroundings::visitVertex(const Segment& before, const Segment& after) {
  const Vec2 vertex = after.p0 - query_.center;
  if (!(length(vertex) < sweptRadius_)) return;
  const bool jutsOut = cross(before.p1 - before.p0, after.p1 - after.p0) < 0;
  if (!jutsOut) return;
  if (!isInFrontOf(before, query_.center) && !isInFrontOf(after, query_.center)) return;
  if (isBelow(scene_[after.sector]) || isAbove(scene_[after.sector])) return;
  const bool stopsBefore = !isOpenAt(before, 1);
  const bool stopsAfter = !isOpenAt(after, 0);
  if (stopsBefore == stopsAfter) return;
  const Segment& wall = stopsBefore ? before : after;
  blockers_.push_back({vertex, vertex + (wall.p1 - wall.p0), true});
}

/// Whether the body fits through the wall there.
bool Surroundings::isOpenAt(const Segment& segment, double fraction) {
  passages_.clear();
  findPassages(scene_, segment, passages_);
  return std::ranges::any_of(passages_, [&](const Passage& passage) {
    const Interval open = passage.openTo(query_.body);
    return open.low <= fraction && fraction <= open.high;
  });
}

/// The body is above the sector.
bool Surroundings::isBelow(const Sector& sector) const {
  return sector.ceiling.flatPortal && scene_.zCeiling(sector) <= query_.body.zClimb + kSkin;
}

/// The body is below the sector.
bool Surroundings::isAbove(const Sector& sector) const {
  return sector.floor.flatPortal && scene_.zFloor(sector) >= query_.body.zHead() - kSkin;
}

void Surroundings::addSupport(double z) {
  if (z <= query_.body.zClimb + kSkin)
    zSupport_ = std::max(zSupport_, z);
  else
    isBuried_ = true;
}

/// A wall that the body is above: its top bears.
void Surroundings::visitWallBelow(const Segment& segment, Interval chord) {
  const bool isOpen = !passages_.empty() && passages_.back().zTop(chord) == kInfinity;
  const double zTop =
      isOpen ? passages_.back().zBottom(chord) : scene_.zCeiling(scene_[segment.sector]);
  addSupport(zTop);
}

/// A wall that the body is below.
void Surroundings::visitWallAbove(const Segment& segment, Interval chord) {
  const bool isOpen = !passages_.empty() && passages_.front().zBottom(chord) == -kInfinity;
  const double zBottom =
      isOpen ? passages_.front().zTop(chord) : scene_.zFloor(scene_[segment.sector]);
  zCap_ = std::min(zCap_, zBottom);
}

/// Adds blockers for the parts of a wall that no passage leaves open.
void Surroundings::block(const Segment& segment, Interval chord) {
  std::ranges::sort(open_, {}, &Interval::low);
  double from = chord.low;
  const auto blockUpTo = [&](double to) {
    if (!(from < to)) return;
    const Vec2 along = segment.p1 - segment.p0;
    const Vec2 a = segment.p0 - query_.center;
    // The ends of a wall are its vertices to the bit: its neighbours share them.
    blockers_.push_back(
        {from == 0 ? a : a + from * along, to == 1 ? segment.p1 - query_.center : a + to * along});
  };
  for (const Interval& open : open_) {
    blockUpTo(std::min(open.low, chord.high));
    from = std::max(from, open.high);
  }
  blockUpTo(chord.high);
}

/// Its top bears a body that can step up to it, and its bottom is a ceiling to one that is below.
void Surroundings::visitBody(std::uint32_t index) {
  const ThingBody& body = scene_.level().bodies[index];
  if (!body.outline.isWithin(query_.center, sweptRadius_ + body.radius)) return;
  if (std::ranges::find(bodies_, index) != bodies_.end()) return;
  bodies_.push_back(index);
  if (body.zTop > query_.body.zClimb + kSkin && body.zBottom >= query_.body.zHead() - kSkin) {
    zCap_ = std::min(zCap_, body.zBottom);
    return;
  }
  addSupport(body.zTop);
  if (body.zTop > query_.body.zClimb + kSkin) block(body);
}

/// Adds blockers for the edges of a thing within reach.
void Surroundings::block(const ThingBody& body) {
  const Vec2 center = query_.center;
  // A player whose axis begins inside the outline is free to leave.
  if (body.outline.isWithin(center, kSkin / 2)) return;
  body.outline.anyEdge(center.x - sweptRadius_, center.x + sweptRadius_, [&](Vec2 p, Vec2 q) {
    const Vec2 a = p - center;
    const Vec2 b = q - center;
    const bool isNear = a == b || (!chordOf(a, b, sweptRadius_).isEmpty() &&
                                   signedDistance(a, b) >= -query_.travel - kSkin);
    if (isNear) blockers_.push_back({a, b, false, body.radius});
    return false;
  });
}

void Surroundings::addFlats(const Sector& sector) {
  if (sector.floor.flatPortal) {
    if (scene_.zFloor(sector) >= query_.zLow)
      followFlat(*sector.floor.flatPortal, FlatPortalSide::Lower);
  } else {
    const double z =
        sector.floorSlope ? highest(sector, *sector.floorSlope, 1) : scene_.zFloor(sector);
    addSupport(z);
  }
  if (sector.ceiling.flatPortal) {
    if (scene_.zCeiling(sector) <= query_.zHigh)
      followFlat(*sector.ceiling.flatPortal, FlatPortalSide::Upper);
  } else {
    const double z =
        sector.ceilingSlope ? -highest(sector, *sector.ceilingSlope, -1) : scene_.zCeiling(sector);
    zCap_ = std::min(zCap_, z);
  }
}

void Surroundings::followFlat(FlatPortalId id, FlatPortalSide to) {
  const FlatPortal& flatPortal = scene_[id];
  for (const SectorId member : flatPortal.members(to))
    if (touches(scene_[member])) add(member);
  // The body's axis may miss its own column by the slack of positions, and a body with less breadth
  // then touches none of them.
  const SectorId column = sectorAcross(scene_.level(), flatPortal, to, query_.center);
  const Vec3 middle{query_.center.x, query_.center.y, flatPortal.z};
  if (contains(scene_, scene_[column], middle, kPositionSlack)) add(column);
}

bool Surroundings::touches(const Sector& sector) const {
  const Vec2 p = query_.center;
  if (!grown(sector.box, sweptRadius_).contains(p)) return false;
  if (contains(scene_.level(), sector, p)) return true;
  bool touches = false;
  forEachWallInReach(sector, [&](const Segment& segment) {
    touches |= !chordOf(segment.p0 - p, segment.p1 - p, sweptRadius_).isEmpty();
  });
  return touches;
}

/// `sign` times the slope's height where that is greatest, of what the disc covers of the sector.
/// It is greatest at the disc's edge straight up, or where the sector's outline leaves the disc.
double Surroundings::highest(const Sector& sector, const Slope& slope, double sign) const {
  double best = -kInfinity;
  const auto take = [&](Vec2 p) { best = std::max(best, sign * slope.zAt(p)); };
  const Vec2 p = query_.center;
  const double steepness = length(slope.gradient);
  const Vec2 uphill = steepness > 0 ? (sign * sweptRadius_ / steepness) * slope.gradient : Vec2{};
  if (contains(scene_.level(), sector, p)) take(p);
  if (contains(scene_.level(), sector, p + uphill)) take(p + uphill);
  forEachWallInReach(sector, [&](const Segment& segment) {
    const Interval chord = chordOf(segment.p0 - p, segment.p1 - p, sweptRadius_);
    if (chord.isEmpty()) return;
    take(lerp(segment.p0, segment.p1, chord.low));
    take(lerp(segment.p0, segment.p1, chord.high));
  });
  if (best == -kInfinity) take(p);  // a body without breadth can miss its sector by the slack
  return best;
}

/// Where a slope comes down to the head, rises too steeply from the feet, or leaves too little room
/// to the other flat, it stops the body like a wall that stands on that contour line.
void Surroundings::addSlopes(const Sector& sector) {
  const UprightBody& body = query_.body;
  const PlaneAt floor = planeAt(scene_.zFloor(sector), sector.floorSlope, query_.center);
  const PlaneAt ceiling = planeAt(scene_.zCeiling(sector), sector.ceilingSlope, query_.center);
  if (sector.ceilingSlope)
    blockWhereAbove0(sector, body.zHead() - kSkin - ceiling.z, -1 * ceiling.gradient);
  const double steepness = length(floor.gradient);
  if (steepness > kSteepestWalk)
    blockWhereAbove0(sector, floor.z - body.zFeet - kSkin, floor.gradient);
  if (!sector.floorSlope) return;
  // Floor and ceiling are each nearest to the body at another point of the disc's edge; the line
  // is moved so that a disc that touches it just fits between them.
  const Vec2 narrowing = floor.gradient - ceiling.gradient;
  const double apart = steepness + length(ceiling.gradient) - length(narrowing);
  const double needed = body.height - kSkin + query_.radius * apart;
  blockWhereAbove0(sector, needed - (ceiling.z - floor.z), narrowing);
}

/// Blocks the contour line on which a value that is known at the centre becomes 0.
void Surroundings::blockWhereAbove0(const Sector& sector, double valueAtCenter, Vec2 gradient) {
  const double steepness = length(gradient);
  if (!(std::abs(valueAtCenter) < sweptRadius_ * steepness)) return;
  const Vec2 foot = (-valueAtCenter / (steepness * steepness)) * gradient;
  const Vec2 along = (1 / steepness) * turned90(gradient);
  const double half = std::sqrt(sweptRadius_ * sweptRadius_ - dot(foot, foot));
  std::pmr::vector<double> cuts({-half, half}, &arena_);
  forEachWallInReach(sector, [&](const Segment& segment) {
    const Vec2 a = segment.p0 - query_.center - foot;
    const Vec2 b = segment.p1 - query_.center - foot;
    const double aSide = cross(along, a);
    const double bSide = cross(along, b);
    if ((aSide > 0) == (bSide > 0)) return;
    const double cut = dot(along, lerp(a, b, aSide / (aSide - bSide)));
    if (cut > -half && cut < half) cuts.push_back(cut);
  });
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Vec2 middle = foot + ((cuts[i] + cuts[i + 1]) / 2) * along;
    if (contains(scene_.level(), sector, query_.center + middle))
      blockers_.push_back({foot + cuts[i] * along, foot + cuts[i + 1] * along});
  }
}

}  // namespace hearth
