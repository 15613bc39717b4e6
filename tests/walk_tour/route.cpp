#include "route.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "lint/sector_reach.h"

namespace hearth::test {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

Vec2 middleOf(const Segment& segment) { return lerp(segment.p0, segment.p1, 0.5); }

}  // namespace

Vec2 nearestOf(const Segment& segment, Vec2 p) {
  const Vec2 along = segment.p1 - segment.p0;
  return lerp(segment.p0, segment.p1,
              std::clamp(dot(p - segment.p0, along) / dot(along, along), 0.0, 1.0));
}

std::optional<std::vector<std::size_t>> moversOnTheWay(const Level& level, const Passages& passages,
                                                       const std::vector<Spot>& spots) {
  const Reach reach(level, passages);
  for (const Spot& spot : spots)
    if (reach.comesTo(spot.sector)) return reach.moversTo(spot.sector);
  return std::nullopt;
}

std::vector<Spot> spotsAt(const Level& level, SectorId sector, Vec2 place) {
  std::vector<Spot> spots;
  for (const SectorId each : sectorsToUse(level, sector)) spots.push_back({each, place});
  return spots;
}

std::vector<Spot> spotsToStart(const Level& level, std::size_t mover) {
  std::vector<Spot> spots;
  for (const MoverSwitch& each : level.switches)
    if (each.mover == mover)
      for (const SectorId sector : sectorsToStart(level, each))
        spots.push_back({sector, middleOf(level[each.segment])});
  return spots;
}

Distances::Distances(const Level& level, const Passages& passages, std::vector<Spot> spots,
                     std::vector<MoverEnds> ends)
    : level_(level),
      spots_(std::move(spots)),
      ends_(std::move(ends)),
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
void Distances::spread(const Passages& passages) {
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
      if (passages.moversToPass(segment.sector, sector, ends_))
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
