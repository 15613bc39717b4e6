#include "level/sprite_index.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// How far a sprite's images reach from its position on the map, whichever way they turn: metres.
double reachOf(const Sprite& sprite) {
  double reach = 0;
  for (const std::vector<SpriteView>& views : sprite.frames)
    for (const SpriteView& view : views) {
      const double across = std::abs(sprite.offset.x) + view.size.x / 2;
      const double along =
          sprite.facing == Facing::Flat ? std::abs(sprite.offset.y) + view.size.y / 2 : 0;
      reach = std::max(reach, length(Vec2{across, along}));
    }
  return reach + 2 * kPositionSlack;
}

Box boxOf(const Sprite& sprite) {
  const Vec2 p = sprite.position.xy();
  return grown({p, p}, reachOf(sprite));
}

/// Whether an opening of its sector is within its reach. Flat portals are, whatever their height.
bool mayRoam(const Level& level, const Sprite& sprite) {
  const Sector& sector = level[sprite.sector];
  if (sector.floor.flatPortal || sector.ceiling.flatPortal) return true;
  const double reach = reachOf(sprite);
  return std::ranges::any_of(level.segmentsOf(sector), [&](const Segment& segment) {
    const Vec2 p = sprite.position.xy();
    return !std::holds_alternative<Solid>(segment.wall) &&
           length(nearestOnSegment(segment.p0, segment.p1, p) - p) <= reach;
  });
}

std::vector<std::uint32_t> roamingIn(const Level& level) {
  std::vector<std::uint32_t> roaming;
  for (std::uint32_t i = 0; i < level.sprites.size(); ++i)
    if (mayRoam(level, level.sprites[i])) roaming.push_back(i);
  return roaming;
}

std::vector<Box> boxesOf(const Level& level, std::span<const std::uint32_t> sprites) {
  std::vector<Box> boxes;
  for (const std::uint32_t i : sprites) boxes.push_back(boxOf(level.sprites[i]));
  return boxes;
}

}  // namespace

SpriteIndex::SpriteIndex(const Level& level)
    : atHome_(level.sprites.size()),
      begin_(level.sprites.empty() ? 0 : level.sectors.size() + 1),
      roaming_(roamingIn(level)),
      tree_(boxesOf(level, roaming_)) {
  const auto sectorOf = [&](std::uint32_t i) { return level.sprites[i].sector; };
  std::iota(atHome_.begin(), atHome_.end(), 0);
  std::ranges::stable_sort(atHome_, {}, sectorOf);
  for (std::size_t i = 0; i < begin_.size(); ++i)
    begin_[i] = static_cast<std::uint32_t>(
        std::ranges::lower_bound(atHome_, SectorId(i), {}, sectorOf) - atHome_.begin());
}

}  // namespace hearth
