#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "load/link/link.h"

namespace hearth {

namespace {

/// The sectors without height between two flat portals. A ray or a falling player passes from one
/// to the next at one height. Where they lead back to the first one, it never ends.
class ThinSectors {
 public:
  explicit ThinSectors(const Level& level) : level_(level), thinBelow_(level.sectors.size(), 0) {
    for (std::size_t i = 0; i < thinBelow_.size(); ++i)
      if (isThin(SectorId(i))) countBelow(SectorId(i));
  }

  /// A sector that leads down to itself.
  std::optional<SectorId> findRing() {
    takeAwayEnds();
    for (std::size_t i = 0; i < thinBelow_.size(); ++i)
      if (thinBelow_[i] > 0) return lowestOf(SectorId(i));
    return std::nullopt;
  }

 private:
  bool isThin(SectorId id) const {
    const Sector& sector = level_[id];
    return sector.floor.flatPortal && sector.ceiling.flatPortal &&
           sector.floor.z == sector.ceiling.z;
  }

  const std::vector<SectorId>& below(SectorId id) const {
    return level_[*level_[id].floor.flatPortal].lower;
  }
  const std::vector<SectorId>& above(SectorId id) const {
    return level_[*level_[id].ceiling.flatPortal].upper;
  }

  void countBelow(SectorId id) {
    thinBelow_[id.index()] = static_cast<std::size_t>(
        std::ranges::count_if(below(id), [this](SectorId other) { return isThin(other); }));
    if (thinBelow_[id.index()] == 0) ends_.push_back(id);
  }

  /// Those below which nothing thin is, then those below which only such were, and so on.
  void takeAwayEnds() {
    while (!ends_.empty()) {
      const SectorId end = ends_.back();
      ends_.pop_back();
      for (const SectorId id : above(end))
        if (isThin(id) && --thinBelow_[id.index()] == 0) ends_.push_back(id);
    }
  }

  /// Down from a sector that is left: there is always another, and so at last a ring.
  SectorId lowestOf(SectorId id) const {
    for (std::size_t i = 0; i < thinBelow_.size(); ++i)
      id = *std::ranges::find_if(below(id),
                                 [this](SectorId other) { return thinBelow_[other.index()] > 0; });
    return id;
  }

  const Level& level_;
  std::vector<std::size_t> thinBelow_;  ///< by SectorId: how many that are left are right below
  std::vector<SectorId> ends_;
};

}  // namespace

void validateRings(Linking& linking) {
  const std::optional<SectorId> ring = ThinSectors(linking.level).findRing();
  if (!ring) return;
  const SectorDescription& sector = linking.description.sectors[ring->index()];
  linking.report.error(
      sector.floor.next->place,
      fmt::format("sector \"{}\" has no height, and the flat portals below it lead back to it",
                  sector.name),
      "give a sector of the ring some height, or take a flat portal away");
}

}  // namespace hearth
