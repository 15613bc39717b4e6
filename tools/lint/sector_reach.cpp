#include "lint/sector_reach.h"

#include <algorithm>
#include <utility>

namespace hearth {

namespace {

std::vector<MoverEnds> firstEnds(const Level& level) {
  std::vector<MoverEnds> ends;
  for (const Mover& mover : level.movers)
    ends.push_back(mover.trigger == MoverTrigger::Loop ? MoverEnds::Both : MoverEnds::Authored);
  return ends;
}

}  // namespace

Reach::Reach(const Level& level, const Passages& passages)
    : Reach(level, passages, level.player->sector, firstEnds(level)) {}

Reach::Reach(const Level& level, const Passages& passages, SectorId from,
             std::vector<MoverEnds> ends)
    : level_(level),
      passages_(passages),
      ends_(std::move(ends)),
      switchSectors_(level.movers.size()),
      arrivals_(level.sectors.size()),
      isReached_(level.sectors.size()),
      reached_{from} {
  isReached_[from.index()] = true;
  do {
    spread();
  } while (startMovers());
}

void Reach::spread() {
  for (std::size_t i = 0; i < reached_.size(); ++i) {
    const SectorId from = reached_[i];
    for (const SectorId next : passages_.next(from)) {
      if (comesTo(next)) continue;
      auto movers = passages_.moversToPass(from, next, ends_);
      if (!movers) continue;
      isReached_[next.index()] = true;
      reached_.push_back(next);
      arrivals_[next.index()] = Arrival{from, std::move(*movers)};
    }
  }
}

/// Whether more may move than before.
bool Reach::startMovers() {
  bool isMore = false;
  for (const MoverStart& start : passages_.starts()) {
    if (has(ends_[start.mover], MoverEnds::To)) continue;
    if (!comesTo(start.from) || (start.to && !comesTo(*start.to))) continue;
    ends_[start.mover] = MoverEnds::Both;
    switchSectors_[start.mover] = start.from;
    isMore = true;
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

}  // namespace hearth
