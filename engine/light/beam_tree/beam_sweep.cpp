#include "light/beam_tree/beam_sweep.h"

#include <algorithm>
#include <cmath>

#include "light/beam_tree/beam_planes.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Whether two directions are one, or lie the other way round.
bool isNarrow(Vec2 begin, Vec2 end) {
  const double sine = cross(begin, end);
  return sine <= 0 || (sine <= kNarrow * length(begin) * length(end) && dot(begin, end) > 0);
}

/// Whether two directions are nearly the same, or nearly opposite. As squares: this is asked of
/// every wall of every window.
bool isOneLine(Vec2 a, Vec2 b) {
  const double sine = cross(a, b);
  return sine * sine <= kNarrow * kNarrow * dot(a, a) * dot(b, b);
}

bool isNear(Vec2 a, Vec2 b) { return dot(a, b) > 0 && isOneLine(a, b); }

bool isClearlyLeftOf(Vec2 direction, Vec2 p) {
  return cross(direction, p) > 0 && !isOneLine(direction, p);
}

/// Whether a direction lies between two others that are less than 180 degrees apart.
bool isBetween(Vec2 begin, Vec2 end, Vec2 direction) {
  return cross(begin, direction) >= 0 && cross(direction, end) >= 0;
}

/// Whether a wall between two points lies clearly to the left or right of all of a window. Most
/// walls of large sectors do.
bool isBeside(const BeamWindow& window, Vec2 a, Vec2 b) {
  return (isClearlyLeftOf(window.end, a) && isClearlyLeftOf(window.end, b)) ||
         (isClearlyLeftOf(-1 * window.begin, a) && isClearlyLeftOf(-1 * window.begin, b));
}

double fractionOf(const BeamWindow& window, Vec2 direction) {
  const double before = cross(window.begin, direction);
  const double after = cross(direction, window.end);
  return std::clamp(before / (before + after), 0.0, 1.0);
}

}  // namespace

double BeamSweep::distanceTo(const Segment& wall, Vec2 direction) const {
  return distanceToLine(light_, wall, direction);
}

void BeamSweep::findParts(const BeamWindow& window) {
  parts_.clear();
  bounds_.clear();
  bounds_.push_back({0, window.begin});
  bounds_.push_back({1, window.end});
  for (const Segment& wall : scene_.segmentsOf(scene_[window.sector])) {
    const Vec2 a = fromLight(wall.p0);
    const Vec2 b = fromLight(wall.p1);
    if (isBeside(window, a, b)) continue;
    if (isNear(a, b)) {
      addBound(window, a);
      addBound(window, b);
    } else if (cross(a, b) > 0) {
      addPart(window, {&wall, false, 0, 1}, a, b);
    } else if (window.hatch) {
      addPart(window, {&wall, true, 0, 1}, b, a);
    }
  }
  std::ranges::sort(parts_, {}, &Part::first);
  std::ranges::stable_sort(bounds_, {}, &Bound::fraction);
}

void BeamSweep::addBound(const BeamWindow& window, Vec2 direction) {
  if (isBetween(window.begin, window.end, direction) || isNear(window.begin, direction) ||
      isNear(window.end, direction))
    bounds_.push_back({fractionOf(window, direction), direction});
}

void BeamSweep::addPart(const BeamWindow& window, Part part, Vec2 a, Vec2 b) {
  addBound(window, a);
  addBound(window, b);
  if (!isBetween(a, b, window.begin)) {
    if (!isBetween(window.begin, window.end, a)) return;
    part.first = fractionOf(window, a);
  }
  if (!isBetween(a, b, window.end)) {
    if (!isBetween(window.begin, window.end, b)) return;
    part.last = fractionOf(window, b);
  }
  parts_.push_back(part);
}

/// Goes along the window from one vertex to the next, and looks where rays go in between.
void BeamSweep::sweep(const BeamWindow& window) {
  finished_.clear();
  doubtful_.clear();
  findParts(window);
  visible_.clear();
  active_.clear();
  std::size_t next = 0;
  std::size_t begin = 0;
  for (std::size_t i = 1; i < bounds_.size(); ++i) {
    if (isNarrow(bounds_[i - 1].direction, bounds_[i].direction)) continue;
    const double middle = (bounds_[i - 1].fraction + bounds_[i].fraction) / 2;
    while (next < parts_.size() && parts_[next].first < middle) active_.push_back(&parts_[next++]);
    std::erase_if(active_, [middle](const Part* part) { return part->last < middle; });
    findStretches(window, unit(bounds_[i - 1].direction) + unit(bounds_[i].direction));
    goOn(begin, i - 1, bounds_[i].direction);
    begin = i;
  }
  stretches_.clear();
  goOn(begin, bounds_.size() - 1, {});
}

/// Of rays between two vertices.
void BeamSweep::findStretches(const BeamWindow& window, Vec2 direction) {
  stretches_.clear();
  crossings_.clear();
  for (const Part* part : active_)
    crossings_.push_back({distanceTo(*part->wall, direction), part->wall, part->isEntrance});
  if (window.hatch) return findStretchesAcross(*window.hatch, direction);
  const double entry = beyond(window.from, direction);
  std::erase_if(crossings_, [entry](const Crossing& c) { return c.distance < entry; });
  const auto nearest = std::ranges::min_element(crossings_, {}, &Crossing::distance);
  if (nearest != crossings_.end()) stretches_.push_back({window.from, nearest->wall});
}

double BeamSweep::beyond(const Segment* wall, Vec2 direction) const {
  return wall ? distanceTo(*wall, direction) * (1 - kSameDistance) : 0;
}

/// Rays come through a flat portal into each stretch in which some of it lies.
void BeamSweep::findStretchesAcross(const BeamHatch& hatch, Vec2 direction) {
  std::ranges::sort(crossings_, {}, &Crossing::distance);
  const double least = beyond(hatch.from, direction);
  const double most = distanceTo(*hatch.to, direction) * (1 + kSameDistance);
  const Segment* from = nullptr;
  double begin = 0;
  for (const Crossing& crossing : crossings_) {
    if (!crossing.isEntrance && crossing.distance >= least && begin <= most)
      stretches_.push_back({from, crossing.wall});
    from = crossing.wall;
    begin = crossing.distance;
  }
}

/// Begins what `stretches_` show from a bound to the direction `end`, and ends what they do not.
/// The bounds from `last` to this one are vertices in one line with the light. A ray may pass
/// between them unless the same wall continues behind them.
void BeamSweep::goOn(std::size_t last, std::size_t bound, Vec2 end) {
  bool isGap = false;
  for (std::size_t i = last; i < bound; ++i)
    isGap |= bounds_[i].direction != bounds_[i + 1].direction;
  seen_.clear();
  bool slips = false;
  for (const BeamStretch stretch : stretches_) {
    const auto before = std::ranges::find(visible_, stretch, &VisibleStretch::stretch);
    const bool goesOn = before != visible_.end();
    seen_.push_back({stretch, goesOn ? before->begin : bounds_[bound].direction, end});
    slips |= endsBetween(stretch, last, bound);
    if (goesOn) visible_.erase(before);
  }
  for (const VisibleStretch& visible : visible_) slips |= endsBetween(visible.stretch, last, bound);
  if (isGap && slips) doubtful_.push_back(unit(bounds_[bound].direction));
  finished_.insert(finished_.end(), visible_.begin(), visible_.end());
  visible_.swap(seen_);
}

/// Whether one of the walls of a stretch has a vertex at one of the bounds from `last` to
/// `bound`.
bool BeamSweep::endsBetween(BeamStretch stretch, std::size_t last, std::size_t bound) const {
  for (std::size_t i = last; i <= bound; ++i)
    for (const Segment* wall : {stretch.from, stretch.to})
      if (wall && (bounds_[i].direction == fromLight(wall->p0) ||
                   bounds_[i].direction == fromLight(wall->p1)))
        return true;
  return false;
}

}  // namespace hearth
