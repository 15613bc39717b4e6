#include "worlds/reach.h"

#include <algorithm>
#include <span>
#include <variant>

namespace hearth::worlds {

namespace {

struct Ends {
  double floor;
  double ceiling;
};

class Reach {
 public:
  explicit Reach(const Level& level)
      : level_(level),
        moversOf_(level.sectors.size()),
        isStarted_(level.movers.size()),
        isReached_(level.sectors.size()) {
    for (std::size_t i = 0; i < level.movers.size(); ++i) {
      isStarted_[i] = level.movers[i].trigger == MoverTrigger::Loop;
      for (const SectorId sector : level.movers[i].sectors) moversOf_[sector.index()].push_back(i);
    }
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
      if (!mayPass(segment.sector, portal->next)) continue;
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

  /// At some ends of the movers that have been started.
  bool mayPass(SectorId from, SectorId to) const {
    std::vector<std::size_t> movers;
    for (const SectorId sector : {from, to})
      for (const std::size_t mover : moversOf_[sector.index()])
        if (isStarted_[mover] && std::ranges::find(movers, mover) == movers.end())
          movers.push_back(mover);
    for (std::uint32_t ends = 0; ends < 1U << movers.size(); ++ends) {
      std::vector<std::size_t> moved;
      for (std::size_t i = 0; i < movers.size(); ++i)
        if ((ends >> i & 1U) != 0) moved.push_back(movers[i]);
      if (fits(endsOf(from, moved), endsOf(to, moved))) return true;
    }
    return false;
  }

  Ends endsOf(SectorId id, std::span<const std::size_t> moved) const {
    Ends ends{level_[id].floor.z, level_[id].ceiling.z};
    for (const std::size_t mover : moversOf_[id.index()])
      if (std::ranges::find(moved, mover) != moved.end())
        (level_.movers[mover].part == FlatPart::Floor ? ends.floor : ends.ceiling) =
            level_.movers[mover].to;
    return ends;
  }

  bool fits(const Ends& from, const Ends& to) const {
    const Player& body = *level_.player;
    const double bottom = std::max(from.floor, to.floor);
    const double top = std::min(from.ceiling, to.ceiling);
    return to.floor - from.floor <= body.stepHeight && top - bottom >= body.height;
  }

  const Level& level_;
  std::vector<std::vector<std::size_t>> moversOf_;  ///< by sector
  std::vector<bool> isStarted_;                     ///< by mover
  std::vector<bool> isReached_;                     ///< by sector
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
