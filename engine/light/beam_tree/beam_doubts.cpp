#include "light/beam_tree/beam_doubts.h"

#include <algorithm>
#include <limits>
#include <span>

#include "math/tolerance.h"

namespace hearth {

template <typename Visit>
void BeamDoubts::forEachBehindFlats(SectorId id, Visit&& visit) const {
  const Sector& sector = scene_[id];
  if (sector.floor.flatPortal) std::ranges::for_each(scene_[*sector.floor.flatPortal].lower, visit);
  if (sector.ceiling.flatPortal)
    std::ranges::for_each(scene_[*sector.ceiling.flatPortal].upper, visit);
}

void BeamDoubts::addLine(SectorId from, Vec2 direction) {
  std::vector<SectorId> sectors{from};
  const auto goTo = [&](SectorId sector) { sectors.push_back(sector); };
  while (!sectors.empty()) {
    const SectorId id = sectors.back();
    sectors.pop_back();
    if (!lines_.insert({id.value, direction.x, direction.y}).second) continue;
    found_.beams.push_back(
        {id, nullptr, nullptr, direction, direction, direction, direction, 0, 0, true});
    forEachWallAlong(id, direction, [&](const Segment& wall) {
      if (const auto openings = scene_.lightOpeningsOf(wall);
          !openings.empty() && touches(wall, direction))
        for (const LightOpening& opening : openings) goTo(opening.next);
    });
    forEachBehindFlats(id, goTo);
  }
}

/// Calls `visit(wall)` for all walls of a sector that a line from the light comes to, and for
/// others.
template <typename Visit>
void BeamDoubts::forEachWallAlong(SectorId id, Vec2 direction, Visit&& visit) const {
  const std::span<const Segment> walls = scene_.segmentsOf(scene_[id]);
  const WallGrid* const grid = scene_.level().wallGridOf(scene_[id]);
  if (!grid) {
    std::ranges::for_each(walls, visit);
    return;
  }
  grid->alongRay(light_, direction, 0, [&](CellId cell) {
    for (const std::uint32_t i : grid->wallsIn(cell)) visit(walls[i]);
    return std::numeric_limits<double>::infinity();
  });
}

/// Whether a line from the light comes to the wall, perhaps, and it does not clearly face away.
bool BeamDoubts::touches(const Segment& wall, Vec2 direction) const {
  const Vec2 a = fromLight(wall.p0);
  const Vec2 b = fromLight(wall.p1);
  const double far = std::max(length(a), length(b));
  const double narrow = 4 * kNarrow * far;
  return cross(a, b) >= -narrow * far && cross(a, direction) >= -narrow &&
         cross(direction, b) >= -narrow && std::max(dot(a, direction), dot(b, direction)) > 0;
}

void BeamDoubts::forget(std::vector<SectorId> sectors) {
  const auto goTo = [&](SectorId sector) { sectors.push_back(sector); };
  while (!sectors.empty()) {
    const SectorId id = sectors.back();
    sectors.pop_back();
    if (!found_.unknown.insert(id.value).second) continue;
    forEachBehindFlats(id, goTo);
    for (const Segment& wall : scene_.segmentsOf(scene_[id])) {
      const Vec2 a = fromLight(wall.p0);
      const Vec2 b = fromLight(wall.p1);
      if (cross(a, b) < -kNarrow * length(a) * length(b)) continue;
      for (const LightOpening& opening : scene_.lightOpeningsOf(wall)) goTo(opening.next);
    }
  }
}

}  // namespace hearth
