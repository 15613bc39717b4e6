#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "level/level.h"

namespace hearth {

/// At which of its ends a mover may stand: a set.
enum class MoverEnds : std::uint8_t { Authored = 1, To = 2, Both = 3 };

constexpr bool has(MoverEnds ends, MoverEnds end) {
  return (static_cast<int>(ends) & static_cast<int>(end)) != 0;
}

/// Where the player starts a mover: in a sector, or by a portal that it crosses from there.
struct MoverStart {
  std::size_t mover;
  SectorId from;
  std::optional<SectorId> to;  ///< where a portal leads that is crossed
};

/// The sectors from which the use key may reach the walls of one: itself, and those beside it.
std::vector<SectorId> sectorsToUse(const Level& level, SectorId sector);
/// Those in which a mover is started at a wall.
std::vector<SectorId> sectorsToStart(const Level& level, const MoverSwitch& wall);

/// From which sectors the player comes to which, with movers at their ends, and where it starts
/// movers. Heights and steps count; breadths and distances do not. Stacks, slopes and flat portals
/// always let it pass.
class Passages {
 public:
  /// The player climbs steps of `climb` metres, and needs `height` metres. The level must outlive
  /// this.
  Passages(const Level& level, double climb, double height);

  /// The sectors that portals lead to from one, each once.
  std::span<const SectorId> next(SectorId sector) const { return links_[sector.index()]; }

  const std::vector<MoverStart>& starts() const { return starts_; }

  /// The fewest movers that must stand at `to` for the player to pass; none where no ends of them
  /// let it pass. `ends` is by mover.
  std::optional<std::vector<std::size_t>> moversToPass(SectorId from, SectorId to,
                                                       std::span<const MoverEnds> ends) const;

  /// Whether the player fits into a sector.
  bool hasRoom(SectorId sector, std::span<const MoverEnds> ends) const {
    return moversToPass(sector, sector, ends).has_value();
  }

 private:
  struct Heights {
    double floor;
    double ceiling;
  };

  std::vector<std::size_t> moversOf(SectorId from, SectorId to) const;
  Heights heightsOf(SectorId id, std::span<const std::size_t> moved) const;
  bool fits(const Heights& from, const Heights& to) const;
  bool isOpen(SectorId from, SectorId to) const;

  const Level& level_;
  std::vector<MoverStart> starts_;
  double climb_;
  double height_;
  std::vector<std::vector<SectorId>> links_;        ///< by sector
  std::vector<std::vector<SectorId>> open_;         ///< likewise: through stacks
  std::vector<std::vector<std::size_t>> moversAt_;  ///< likewise
};

}  // namespace hearth
