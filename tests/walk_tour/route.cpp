#include "route.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <variant>

namespace hearth::test {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

Vec2 middleOf(const Segment& segment) { return lerp(segment.p0, segment.p1, 0.5); }

/// Spreads from the start through what can be passed, then starts all movers whose switches it has
/// come to, and so on. So it comes to every sector with as few movers as it can.
class Spread {
 public:
  Spread(const Level& level, const worlds::Passages& passages)
      : level_(level),
        passages_(passages),
        isStarted_(level.movers.size()),
        switchSectors_(level.movers.size()),
        arrivals_(level.sectors.size()),
        isReached_(level.sectors.size()) {
    for (std::size_t i = 0; i < isStarted_.size(); ++i)
      isStarted_[i] = level.movers[i].trigger == MoverTrigger::Loop;
    isReached_[level.player->sector.index()] = true;
    while (goOn() || startMovers()) {
    }
  }

  bool reaches(SectorId sector) const { return isReached_[sector.index()]; }

  std::vector<std::size_t> moversTo(SectorId sector) {
    plan(sector);
    return std::move(planned_);
  }

 private:
  struct Arrival {
    SectorId from;
    std::vector<std::size_t> movers;
  };

  /// Whether there is more than before.
  bool goOn() {
    bool isMore = false;
    for (const Segment& segment : level_.segments) {
      const Portal* portal = std::get_if<Portal>(&segment.wall);
      if (!portal || !reaches(segment.sector) || reaches(portal->next)) continue;
      auto movers = passages_.moversToPass(segment.sector, portal->next, isStarted_);
      if (!movers) continue;
      isReached_[portal->next.index()] = isMore = true;
      arrivals_[portal->next.index()] = Arrival{segment.sector, std::move(*movers)};
    }
    return isMore;
  }

  bool startMovers() {
    bool isMore = false;
    for (std::size_t i = 0; i < isStarted_.size(); ++i) {
      if (isStarted_[i]) continue;
      for (const Spot& spot : spotsToStart(level_, i))
        if (!isStarted_[i] && reaches(spot.sector)) {
          isStarted_[i] = isMore = true;
          switchSectors_[i] = spot.sector;
        }
    }
    return isMore;
  }

  void plan(SectorId sector) {
    const std::optional<Arrival>& arrival = arrivals_[sector.index()];
    if (!arrival) return;
    plan(arrival->from);
    for (const std::size_t mover : arrival->movers) {
      if (!switchSectors_[mover] || std::ranges::find(planned_, mover) != planned_.end()) continue;
      plan(*switchSectors_[mover]);
      planned_.push_back(mover);
    }
  }

  const Level& level_;
  const worlds::Passages& passages_;
  std::vector<bool> isStarted_;                         ///< by mover
  std::vector<std::optional<SectorId>> switchSectors_;  ///< by mover; none of loops
  std::vector<std::optional<Arrival>> arrivals_;        ///< by sector; none of the first
  std::vector<bool> isReached_;                         ///< by sector
  std::vector<std::size_t> planned_;
};

}  // namespace

Vec2 nearestOf(const Segment& segment, Vec2 p) {
  const Vec2 along = segment.p1 - segment.p0;
  return lerp(segment.p0, segment.p1,
              std::clamp(dot(p - segment.p0, along) / dot(along, along), 0.0, 1.0));
}

std::optional<std::vector<std::size_t>> moversOnTheWay(const Level& level,
                                                       const worlds::Passages& passages,
                                                       const std::vector<Spot>& spots) {
  Spread spread(level, passages);
  for (const Spot& spot : spots)
    if (spread.reaches(spot.sector)) return spread.moversTo(spot.sector);
  return std::nullopt;
}

std::vector<Spot> spotsAt(const Level& level, SectorId sector, Vec2 place) {
  std::vector<Spot> spots{{sector, place}};
  for (const SegmentId entrance : level.entrancesOf(level[sector]))
    spots.push_back({level[entrance].sector, place});
  return spots;
}

std::vector<Spot> spotsToStart(const Level& level, std::size_t mover) {
  std::vector<Spot> spots;
  for (const MoverSwitch& each : level.switches) {
    if (each.mover != mover) continue;
    const Segment& segment = level[each.segment];
    const std::vector<Spot> more = spotsAt(level, segment.sector, middleOf(segment));
    spots.insert(spots.end(), more.begin(), each.isCrossed ? more.begin() + 1 : more.end());
  }
  return spots;
}

Distances::Distances(const Level& level, const worlds::Passages& passages, std::vector<Spot> spots,
                     std::vector<bool> isStarted)
    : level_(level),
      spots_(std::move(spots)),
      isStarted_(std::move(isStarted)),
      through_(level.segments.size(), kFar) {
  spread(passages);
}

double Distances::within(const Spot& spot) const {
  double least = kFar;
  for (const Spot& each : spots_)
    if (each.sector == spot.sector) least = std::min(least, length(each.place - spot.place));
  return least;
}

/// Dijkstra's search, from the spots back.
void Distances::spread(const worlds::Passages& passages) {
  using Entry = std::pair<double, SegmentId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto improve = [&](const Segment& segment, double distance) {
    if (distance >= through_[segment.id.index()]) return;
    through_[segment.id.index()] = distance;
    queue.emplace(distance, segment.id);
  };
  const auto improveEntrances = [&](SectorId sector, const auto& distanceFrom) {
    for (const SegmentId id : level_.entrancesOf(level_[sector])) {
      const Segment& segment = level_[id];
      if (passages.moversToPass(segment.sector, sector, isStarted_))
        improve(segment, distanceFrom(middleOf(segment)));
    }
  };
  for (const Spot& spot : spots_)
    improveEntrances(spot.sector, [&](Vec2 p) { return length(spot.place - p); });
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.first > through_[entry.second.index()]) continue;
    const Segment& segment = level_[entry.second];
    improveEntrances(segment.sector,
                     [&](Vec2 p) { return entry.first + length(middleOf(segment) - p); });
  }
}

double Distances::from(const Spot& spot) const {
  double least = within(spot);
  for (const Segment& segment : level_.segmentsOf(level_[spot.sector]))
    least = std::min(
        least, length(nearestOf(segment, spot.place) - spot.place) + through_[segment.id.index()]);
  return least;
}

}  // namespace hearth::test
