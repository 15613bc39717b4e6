#include "worlds/reach.h"

#include <algorithm>
#include <variant>

#include "worlds/passages.h"

namespace hearth::worlds {

namespace {

class Reach {
 public:
  explicit Reach(const Level& level)
      : level_(level),
        passages_(level, level.player->stepHeight),
        isStarted_(level.movers.size()),
        isReached_(level.sectors.size()) {
    for (std::size_t i = 0; i < level.movers.size(); ++i)
      isStarted_[i] = level.movers[i].trigger == MoverTrigger::Loop;
  }

  std::vector<bool> find(SectorId start) {
    isReached_[start.index()] = true;
    while (spread() || startMovers()) {
    }
    return isReached_;
  }

 private:
  /// Whether there is more than before.
  bool spread() {
    bool isMore = false;
    for (const Segment& segment : level_.segments) {
      const Portal* portal = std::get_if<Portal>(&segment.wall);
      if (!portal || !isReached_[segment.sector.index()] || isReached_[portal->next.index()])
        continue;
      if (!passages_.moversToPass(segment.sector, portal->next, isStarted_)) continue;
      isReached_[portal->next.index()] = isMore = true;
    }
    return isMore;
  }

  bool startMovers() {
    bool isMore = false;
    for (const MoverSwitch& each : level_.switches) {
      const SectorId sector = level_[each.segment].sector;
      if (isStarted_[each.mover]) continue;
      isStarted_[each.mover] =
          each.isCrossed ? isReached_[sector.index()] : mayUseWallsOf(level_, sector, isReached_);
      isMore = isMore || isStarted_[each.mover];
    }
    return isMore;
  }

  const Level& level_;
  Passages passages_;
  std::vector<bool> isStarted_;  ///< by mover
  std::vector<bool> isReached_;  ///< by sector
};

}  // namespace

std::vector<bool> reachedSectors(const Level& level) {
  if (!level.player) return std::vector<bool>(level.sectors.size());
  return Reach(level).find(level.player->sector);
}

bool mayUseWallsOf(const Level& level, SectorId sector, const std::vector<bool>& isReached) {
  return isReached[sector.index()] ||
         std::ranges::any_of(level.entrancesOf(level[sector]), [&](SegmentId entrance) {
           return isReached[level[entrance].sector.index()];
         });
}

}  // namespace hearth::worlds
