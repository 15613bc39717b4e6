#include "worlds/reach.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace hearth::worlds {

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

Reach::Reach(const Level& level, const Passages& passages)
    : level_(level),
      passages_(passages),
      isStarted_(level.movers.size()),
      switchSectors_(level.movers.size()),
      arrivals_(level.sectors.size()),
      isReached_(level.sectors.size()) {
  for (std::size_t i = 0; i < isStarted_.size(); ++i)
    isStarted_[i] = level.movers[i].trigger == MoverTrigger::Loop;
  isReached_[level.player->sector.index()] = true;
  while (spread() || startMovers()) {
  }
}

/// Whether there is more than before.
bool Reach::spread() {
  bool isMore = false;
  for (const Segment& segment : level_.segments) {
    const Portal* portal = std::get_if<Portal>(&segment.wall);
    if (!portal || !comesTo(segment.sector) || comesTo(portal->next)) continue;
    auto movers = passages_.moversToPass(segment.sector, portal->next, isStarted_);
    if (!movers) continue;
    isReached_[portal->next.index()] = isMore = true;
    arrivals_[portal->next.index()] = Arrival{segment.sector, std::move(*movers)};
  }
  return isMore;
}

bool Reach::startMovers() {
  bool isMore = false;
  for (const MoverSwitch& each : level_.switches)
    for (const SectorId sector : sectorsToStart(level_, each)) {
      if (isStarted_[each.mover] || !comesTo(sector)) continue;
      isStarted_[each.mover] = isMore = true;
      switchSectors_[each.mover] = sector;
    }
  return isMore;
}

bool Reach::mayUseWallsOf(SectorId sector) const {
  return std::ranges::any_of(sectorsToUse(level_, sector),
                             [this](SectorId each) { return comesTo(each); });
}

std::vector<std::size_t> Reach::moversTo(SectorId sector) const {
  std::vector<std::size_t> planned;
  plan(sector, planned);
  return planned;
}

void Reach::plan(SectorId sector, std::vector<std::size_t>& planned) const {
  const std::optional<Arrival>& arrival = arrivals_[sector.index()];
  if (!arrival) return;
  plan(arrival->from, planned);
  for (const std::size_t mover : arrival->movers) {
    if (!switchSectors_[mover] || std::ranges::find(planned, mover) != planned.end()) continue;
    plan(*switchSectors_[mover], planned);
    planned.push_back(mover);
  }
}

}  // namespace hearth::worlds
