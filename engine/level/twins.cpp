#include "level/twins.h"

#include <algorithm>
#include <tuple>

namespace hearth {

namespace {

auto keyOf(SectorId sector, Vec2 p0, Vec2 p1) {
  return std::tuple(sector.value, p0.x, p0.y, p1.x, p1.y);
}

}  // namespace

TwinIndex::TwinIndex(const Level& level) : level_(level) {
  std::vector<bool> isTarget(level.sectors.size());
  for (const Segment& segment : level.segments)
    for (const SectorId target : targetsOf(segment.wall)) isTarget[target.index()] = true;
  for (std::size_t i = 0; i < level.segments.size(); ++i)
    if (isTarget[level.segments[i].sector.index()]) sorted_.push_back(SegmentId(i));
  std::stable_sort(sorted_.begin(), sorted_.end(), [&](SegmentId a, SegmentId b) {
    return keyOf(level[a].sector, level[a].p0, level[a].p1) <
           keyOf(level[b].sector, level[b].p0, level[b].p1);
  });
}

std::optional<SegmentId> TwinIndex::find(const Segment& segment, SectorId next) const {
  const auto wanted = keyOf(next, segment.p1, segment.p0);
  const auto found =
      std::lower_bound(sorted_.begin(), sorted_.end(), wanted, [&](SegmentId id, const auto& key) {
        return keyOf(level_[id].sector, level_[id].p0, level_[id].p1) < key;
      });
  if (found == sorted_.end()) return std::nullopt;
  const Segment& twin = level_[*found];
  if (keyOf(twin.sector, twin.p0, twin.p1) != wanted) return std::nullopt;
  return *found;
}

}  // namespace hearth
