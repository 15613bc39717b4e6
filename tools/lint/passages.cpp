#include "lint/passages.h"

#include <algorithm>

#include "lint/sector_graph.h"

namespace hearth {

namespace {

bool isLevel(const Sector& sector) {
  return !sector.floorSlope && !sector.ceilingSlope && !sector.floor.flatPortal &&
         !sector.ceiling.flatPortal;
}

std::vector<MoverStart> startsOf(const Level& level) {
  std::vector<MoverStart> starts;
  const auto use = [&](std::size_t mover, SectorId sector) {
    for (const SectorId each : sectorsToUse(level, sector)) starts.push_back({mover, each, {}});
  };
  for (const MoverSwitch& wall : level.switches) {
    const Segment& segment = level[wall.segment];
    if (wall.isCrossed)
      starts.push_back({wall.mover, segment.sector, targetOf(segment.wall, *wall.subWall)});
    else
      use(wall.mover, segment.sector);
  }
  for (std::size_t i = 0; i < level.movers.size(); ++i) {
    const Mover& mover = level.movers[i];
    if (mover.trigger == MoverTrigger::Use)
      for (const SectorId sector : mover.sectors) use(i, sector);
    if (mover.trigger == MoverTrigger::Enter)
      for (const SectorId zone : mover.zones) starts.push_back({i, zone, {}});
  }
  return starts;
}

}  // namespace

std::vector<SectorId> sectorsToUse(const Level& level, SectorId sector) {
  std::vector<SectorId> sectors{sector};
  for (const SegmentId entrance : level.entrancesOf(level[sector]))
    sectors.push_back(level[entrance].sector);
  return sectors;
}

std::vector<SectorId> sectorsToStart(const Level& level, const MoverSwitch& wall) {
  const SectorId own = level[wall.segment].sector;
  return wall.isCrossed ? std::vector{own} : sectorsToUse(level, own);
}

Passages::Passages(const Level& level, double climb, double height)
    : level_(level),
      starts_(startsOf(level)),
      climb_(climb),
      height_(height),
      links_(sectorGraph(level)),
      open_(level.sectors.size()),
      moversAt_(level.sectors.size()) {
  for (const Segment& segment : level.segments)
    if (std::holds_alternative<Stack>(segment.wall))
      std::ranges::copy(targetsOf(segment.wall), std::back_inserter(open_[segment.sector.index()]));
  for (std::size_t i = 0; i < level.movers.size(); ++i)
    for (const SectorId sector : level.movers[i].sectors) moversAt_[sector.index()].push_back(i);
}

std::optional<std::vector<std::size_t>> Passages::moversToPass(
    SectorId from, SectorId to, std::span<const MoverEnds> ends) const {
  if (isOpen(from, to)) return std::vector<std::size_t>{};
  const std::vector<std::size_t> movers = moversOf(from, to);
  std::optional<std::vector<std::size_t>> fewest;
  for (std::uint32_t choice = 0; choice < 1U << movers.size(); ++choice) {
    std::vector<std::size_t> moved;
    bool isAllowed = true;
    for (std::size_t i = 0; i < movers.size(); ++i) {
      const bool isMoved = (choice >> i & 1U) != 0;
      isAllowed = isAllowed && has(ends[movers[i]], isMoved ? MoverEnds::To : MoverEnds::Authored);
      if (isMoved) moved.push_back(movers[i]);
    }
    if (!isAllowed || (fewest && fewest->size() <= moved.size())) continue;
    if (fits(heightsOf(from, moved), heightsOf(to, moved))) fewest = moved;
  }
  return fewest;
}

std::vector<std::size_t> Passages::moversOf(SectorId from, SectorId to) const {
  std::vector<std::size_t> movers = moversAt_[from.index()];
  for (const std::size_t mover : moversAt_[to.index()])
    if (std::ranges::find(movers, mover) == movers.end()) movers.push_back(mover);
  return movers;
}

Passages::Heights Passages::heightsOf(SectorId id, std::span<const std::size_t> moved) const {
  Heights heights{level_[id].floor.z, level_[id].ceiling.z};
  for (const std::size_t mover : moversAt_[id.index()])
    if (std::ranges::find(moved, mover) != moved.end())
      (level_.movers[mover].part == FlatPart::Floor ? heights.floor : heights.ceiling) =
          level_.movers[mover].to;
  return heights;
}

bool Passages::fits(const Heights& from, const Heights& to) const {
  const double bottom = std::max(from.floor, to.floor);
  const double top = std::min(from.ceiling, to.ceiling);
  return to.floor - from.floor <= climb_ && top - bottom >= height_;
}

/// Where heights are not those of two level floors and ceilings.
bool Passages::isOpen(SectorId from, SectorId to) const {
  return !isLevel(level_[from]) || !isLevel(level_[to]) ||
         std::ranges::find(open_[from.index()], to) != open_[from.index()].end();
}

}  // namespace hearth
