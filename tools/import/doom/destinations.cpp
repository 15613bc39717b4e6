#include "import/doom/destinations.h"

#include <algorithm>
#include <climits>

namespace hearth::doom {

namespace {

/// An open door ends so many units below the lowest ceiling around.
constexpr int kLintel = 4;
/// What some flats keep from others.
constexpr int kGap = 8;

}  // namespace

Destinations::Destinations(const Map& map) : map_(map), neighbours_(map.sectors.size()) {
  for (std::uint32_t i = 0; i < map.sectors.size(); ++i)
    if (map.sectors[i].tag != 0) tagged_[map.sectors[i].tag].push_back(i);
  findNeighbours();
  doors_ = movedBy([](const LineType& type) { return type.destination == Destination::DoorTop; });
}

void Destinations::findNeighbours() {
  for (const Line& line : map_.lines) {
    if (!line.sides[0] || !line.sides[1]) continue;
    const std::uint32_t a = map_.sides[*line.sides[0]].sector;
    const std::uint32_t b = map_.sides[*line.sides[1]].sector;
    if (a == b) continue;
    neighbours_[a].insert(b);
    neighbours_[b].insert(a);
  }
}

std::set<std::uint32_t> Destinations::movedBy(bool (*counts)(const LineType&)) const {
  std::set<std::uint32_t> sectors;
  std::set<std::uint16_t> tags;
  for (const Line& line : map_.lines) {
    const LineType* type = findLineType(line.special);
    if (!type || !counts(*type)) continue;
    if (type->activation != Activation::Push && !tags.insert(line.tag).second) continue;
    const std::vector<std::uint32_t> moved = sectorsOf(line, *type);
    sectors.insert(moved.begin(), moved.end());
  }
  return sectors;
}

std::vector<std::uint32_t> Destinations::sectorsOf(const Line& line, const LineType& type) const {
  if (type.activation != Activation::Push) {
    const auto found = tagged_.find(line.tag);
    return found == tagged_.end() ? std::vector<std::uint32_t>{} : found->second;
  }
  if (!line.sides[1]) return {};
  return {map_.sides[*line.sides[1]].sector};
}

std::optional<int> Destinations::heightFor(Destination destination, std::uint32_t sector) const {
  const Sector& own = map_.sectors[sector];
  switch (destination) {
    case Destination::DoorTop:
      return doorTop(sector);
    case Destination::OwnFloor:
      return own.floor;
    case Destination::AboveOwnFloor:
      return own.floor + kGap;
    case Destination::HighestCeiling:
      return highestCeiling(sector);
    case Destination::LowestFloor:
      return lowestFloor(sector);
    case Destination::HighestFloor:
      return highestFloor(sector);
    case Destination::AboveHighestFloor:
      return aboveHighestFloor(sector);
    case Destination::NextFloor:
      return nextFloor(sector);
    case Destination::LowestCeiling:
      return lowestCeiling(sector);
    case Destination::BelowLowestCeiling:
      return lowestCeiling(sector) - kGap;
    case Destination::Up24:
      return own.floor + 24;
    case Destination::Up32:
      return own.floor + 32;
    case Destination::Up512:
      return own.floor + 512;
    default:
      return std::nullopt;
  }
}

/// Leaves of one door open together: they do not count as what is around.
std::optional<int> Destinations::doorTop(std::uint32_t sector) const {
  std::optional<int> lowest;
  for (const std::uint32_t neighbour : neighbours_[sector])
    if (!doors_.contains(neighbour))
      lowest = std::min(map_.sectors[neighbour].ceiling, lowest.value_or(INT_MAX));
  if (!lowest) return std::nullopt;
  return std::max(map_.sectors[sector].ceiling, *lowest - kLintel);
}

int Destinations::lowestFloor(std::uint32_t sector) const {
  int lowest = map_.sectors[sector].floor;
  for (const std::uint32_t neighbour : neighbours_[sector])
    lowest = std::min(lowest, map_.sectors[neighbour].floor);
  return lowest;
}

std::optional<int> Destinations::highestFloor(std::uint32_t sector) const {
  std::optional<int> highest;
  for (const std::uint32_t neighbour : neighbours_[sector])
    highest = std::max(map_.sectors[neighbour].floor, highest.value_or(INT_MIN));
  return highest;
}

/// A floor that stands at that height stays there.
std::optional<int> Destinations::aboveHighestFloor(std::uint32_t sector) const {
  const std::optional<int> highest = highestFloor(sector);
  if (!highest || *highest == map_.sectors[sector].floor) return highest;
  return *highest + kGap;
}

std::optional<int> Destinations::nextFloor(std::uint32_t sector) const {
  std::optional<int> next;
  for (const std::uint32_t neighbour : neighbours_[sector])
    if (map_.sectors[neighbour].floor > map_.sectors[sector].floor)
      next = std::min(map_.sectors[neighbour].floor, next.value_or(INT_MAX));
  return next;
}

std::optional<int> Destinations::highestCeiling(std::uint32_t sector) const {
  std::optional<int> highest;
  for (const std::uint32_t neighbour : neighbours_[sector])
    highest = std::max(map_.sectors[neighbour].ceiling, highest.value_or(INT_MIN));
  return highest;
}

int Destinations::lowestCeiling(std::uint32_t sector) const {
  int lowest = map_.sectors[sector].ceiling;
  for (const std::uint32_t neighbour : neighbours_[sector])
    lowest = std::min(lowest, map_.sectors[neighbour].ceiling);
  return lowest;
}

}  // namespace hearth::doom
