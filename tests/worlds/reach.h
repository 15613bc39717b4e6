#pragma once

#include <optional>
#include <vector>

#include "level/level.h"
#include "worlds/passages.h"

namespace hearth::worlds {

/// The sectors from which the use key may reach the walls of one: itself, and those beside it.
std::vector<SectorId> sectorsToUse(const Level& level, SectorId sector);
/// Those in which a mover is started at a wall.
std::vector<SectorId> sectorsToStart(const Level& level, const MoverSwitch& wall);

/// To which sectors the player may come from where it starts, if every mover whose switches and
/// crossings it comes to may stand at either end. Heights and steps count; breadths and distances
/// do not. It comes to each sector with as few movers as it can.
class Reach {
 public:
  /// The level has a player. Both must outlive this.
  Reach(const Level& level, const Passages& passages);

  bool comesTo(SectorId sector) const { return isReached_[sector.index()]; }
  /// Whether what is on the walls of a sector can be used.
  bool mayUseWallsOf(SectorId sector) const;
  /// The movers that must be started on the way to a sector, in an order in which the switches of
  /// each can.
  std::vector<std::size_t> moversTo(SectorId sector) const;

 private:
  struct Arrival {
    SectorId from;
    std::vector<std::size_t> movers;
  };

  bool spread();
  bool startMovers();
  void plan(SectorId sector, std::vector<std::size_t>& planned) const;

  const Level& level_;
  const Passages& passages_;
  std::vector<bool> isStarted_;                         ///< by mover
  std::vector<std::optional<SectorId>> switchSectors_;  ///< by mover; none of loops
  std::vector<std::optional<Arrival>> arrivals_;        ///< by sector; none of the first
  std::vector<bool> isReached_;                         ///< by sector
};

}  // namespace hearth::worlds
