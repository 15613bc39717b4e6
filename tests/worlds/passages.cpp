#include "worlds/passages.h"

#include <algorithm>
#include <cstdint>

namespace hearth::worlds {

Passages::Passages(const Level& level, double climb)
    : level_(level), climb_(climb), moversOf_(level.sectors.size()) {
  for (std::size_t i = 0; i < level.movers.size(); ++i)
    for (const SectorId sector : level.movers[i].sectors) moversOf_[sector.index()].push_back(i);
}

std::optional<std::vector<std::size_t>> Passages::moversToPass(
    SectorId from, SectorId to, const std::vector<bool>& isStarted) const {
  std::vector<std::size_t> movers;
  for (const SectorId sector : {from, to})
    for (const std::size_t mover : moversOf_[sector.index()])
      if (isStarted[mover] && std::ranges::find(movers, mover) == movers.end())
        movers.push_back(mover);
  std::optional<std::vector<std::size_t>> fewest;
  for (std::uint32_t ends = 0; ends < 1U << movers.size(); ++ends) {
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < movers.size(); ++i)
      if ((ends >> i & 1U) != 0) moved.push_back(movers[i]);
    if (fewest && fewest->size() <= moved.size()) continue;
    if (fits(endsOf(from, moved), endsOf(to, moved))) fewest = moved;
  }
  return fewest;
}

Passages::Ends Passages::endsOf(SectorId id, std::span<const std::size_t> moved) const {
  Ends ends{level_[id].floor.z, level_[id].ceiling.z};
  for (const std::size_t mover : moversOf_[id.index()])
    if (std::ranges::find(moved, mover) != moved.end())
      (level_.movers[mover].part == FlatPart::Floor ? ends.floor : ends.ceiling) =
          level_.movers[mover].to;
  return ends;
}

bool Passages::fits(const Ends& from, const Ends& to) const {
  const double bottom = std::max(from.floor, to.floor);
  const double top = std::min(from.ceiling, to.ceiling);
  return to.floor - from.floor <= climb_ && top - bottom >= level_.player->height;
}

}  // namespace hearth::worlds
