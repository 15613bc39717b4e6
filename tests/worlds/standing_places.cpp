#include "worlds/standing_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "level/locate.h"
#include "math/predicates.h"
#include "random_levels/random.h"

namespace hearth::worlds {

namespace {

using random_levels::Random;

// Of Doom's player, 1/32 m for each unit, so that all places are of one body.
constexpr double kBodyHeight = 56.0 / 32;
constexpr double kEyeHeight = 41.0 / 32;

constexpr double kFromWalls = 0.1;  ///< metres: the steps of a stair are no broader than the body
constexpr int kTries = 200;         ///< in a sector: a long one that winds fills little of its box
/// Sectors for each place that is wanted: some are too narrow.
constexpr std::size_t kSectorsForAPlace = 20;

std::vector<SectorId> sectorsWithRoom(const Level& level) {
  std::vector<SectorId> found;
  for (std::size_t i = 0; i < level.sectors.size(); ++i)
    if (level.sectors[i].ceiling.z - level.sectors[i].floor.z >= kBodyHeight) found.emplace_back(i);
  return found;
}

bool isWellInside(const Level& level, const Sector& sector, Vec2 p) {
  return contains(level, sector, p) &&
         std::ranges::all_of(level.segmentsOf(sector), [&](const Segment& wall) {
           return length(nearestOnSegment(wall.p0, wall.p1, p) - p) >= kFromWalls;
         });
}

/// None where the sector is too narrow to be hit.
std::optional<Vec2> placeIn(const Level& level, const Sector& sector, Random& random) {
  for (int i = 0; i < kTries; ++i) {
    const double x = random.real(sector.box.min.x, sector.box.max.x);
    const double y = random.real(sector.box.min.y, sector.box.max.y);
    if (isWellInside(level, sector, {x, y})) return Vec2{x, y};
  }
  return std::nullopt;
}

Shot shotOf(std::string name, SectorId sector, Vec3 eye, double angle, ImageSize size) {
  Shot shot{std::move(name), sector, eye, angle};
  shot.width = size.width;
  shot.height = size.height;
  return shot;
}

}  // namespace

std::vector<Shot> standingPlaces(const Level& level, std::size_t count, std::uint64_t seed,
                                 ImageSize size) {
  std::vector<Shot> shots;
  if (const auto& player = level.player)
    shots.push_back(shotOf("start", player->sector, player->eye, player->angle, size));
  const std::vector<SectorId> sectors = sectorsWithRoom(level);
  const std::size_t wanted = shots.size() + (sectors.empty() ? 0 : count);
  Random random(seed);
  for (std::size_t i = 0; i < kSectorsForAPlace * count && shots.size() < wanted; ++i) {
    const SectorId id = random.pickFrom(sectors);
    const double angle = random.real(0, 360);
    const auto place = placeIn(level, level[id], random);
    if (!place) continue;
    const Vec3 eye{place->x, place->y, level[id].floor.z + kEyeHeight};
    const auto name = fmt::format("{} ({:.17g},{:.17g},{:.17g},{:.17g} in sector {})", i, eye.x,
                                  eye.y, eye.z, angle, level[id].name);
    shots.push_back(shotOf(name, id, eye, angle, size));
  }
  return shots;
}

}  // namespace hearth::worlds
