#include "lint/sector_graph.h"

#include <algorithm>

#include "load/link/link.h"

namespace hearth {

namespace {

void sortEach(std::vector<std::vector<SectorId>>& links) {
  for (std::vector<SectorId>& targets : links) {
    std::ranges::sort(targets);
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
  }
}

/// Marks `start` and all sectors that links lead to from there without passing marked ones. Returns
/// these sectors, in order.
std::vector<SectorId> follow(const std::vector<std::vector<SectorId>>& links, SectorId start,
                             std::vector<bool>& isReached) {
  std::vector<SectorId> reached{start};
  isReached[start.index()] = true;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const SectorId next : links[reached[i].index()]) {
      if (isReached[next.index()]) continue;
      isReached[next.index()] = true;
      reached.push_back(next);
    }
  std::ranges::sort(reached);
  return reached;
}

}  // namespace

std::vector<std::vector<SectorId>> sectorGraph(const Level& level) {
  std::vector<std::vector<SectorId>> links(level.sectors.size());
  for (const Segment& segment : level.segments)
    for (const SectorId next : targetsOf(segment.wall))
      links[segment.sector.index()].push_back(next);
  for (const FlatPortal& flatPortal : level.flatPortals)
    for (const SectorId upper : flatPortal.upper)
      for (const SectorId lower : flatPortal.lower) {
        links[upper.index()].push_back(lower);
        links[lower.index()].push_back(upper);
      }
  sortEach(links);
  return links;
}

std::vector<std::vector<SectorId>> undirected(const std::vector<std::vector<SectorId>>& links) {
  std::vector<std::vector<SectorId>> both = links;
  for (std::size_t i = 0; i < links.size(); ++i)
    for (const SectorId next : links[i]) both[next.index()].push_back(SectorId(i));
  sortEach(both);
  return both;
}

std::vector<bool> reachableFrom(const std::vector<std::vector<SectorId>>& links, SectorId start) {
  std::vector<bool> isReached(links.size(), false);
  follow(links, start, isReached);
  return isReached;
}

std::vector<SectorId> newlyReachableFrom(const std::vector<std::vector<SectorId>>& links,
                                         SectorId start, std::vector<bool> known) {
  if (known[start.index()]) return {};
  return follow(links, start, known);
}

std::vector<std::vector<SectorId>> connectedComponents(
    const std::vector<std::vector<SectorId>>& links) {
  std::vector<std::vector<SectorId>> parts;
  std::vector<bool> isReached(links.size(), false);
  for (std::size_t i = 0; i < links.size(); ++i)
    if (!isReached[i]) parts.push_back(follow(links, SectorId(i), isReached));
  return parts;
}

double areaOf(const Level& level, std::span<const SectorId> sectors) {
  double twice = 0;
  for (const SectorId sector : sectors)
    for (const Segment& segment : level.segmentsOf(level[sector]))
      twice += cross(segment.p0 - level[sector].box.min, segment.p1 - level[sector].box.min);
  return twice / 2;
}

MovingWalls::MovingWalls(const Level& level) : isMoving_(level.sectors.size()) {
  for (const Mover& mover : level.movers)
    for (const SectorId sector : mover.sectors) isMoving_[sector.index()] = true;
}

bool MovingWalls::has(const Segment& segment) const {
  return isMoving_[segment.sector.index()] ||
         std::ranges::any_of(targetsOf(segment.wall),
                             [&](SectorId next) { return isMoving_[next.index()]; });
}

}  // namespace hearth
