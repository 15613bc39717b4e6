#pragma once

#include <optional>
#include <vector>

#include "lint/passages.h"

namespace hearth {

/// To which sectors the player may come from one, if every mover that it starts on the way may
/// stand at `to`, too. Heights and steps count; breadths and distances do not. It comes to each
/// sector with as few movers as it can.
class Reach {
 public:
  /// From where the player starts, with the movers as a walk finds them. The level has a player.
  /// Both must outlive this.
  Reach(const Level& level, const Passages& passages);
  /// With movers at these ends, by mover.
  Reach(const Level& level, const Passages& passages, SectorId from, std::vector<MoverEnds> ends);

  bool comesTo(SectorId sector) const { return isReached_[sector.index()]; }
  /// In the order in which it comes to them.
  const std::vector<SectorId>& sectors() const { return reached_; }
  /// The ends at which movers may stand at last, by mover.
  const std::vector<MoverEnds>& ends() const { return ends_; }
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

  void spread();
  bool startMovers();
  void plan(SectorId sector, std::vector<std::size_t>& planned) const;

  const Level& level_;
  const Passages& passages_;
  std::vector<MoverEnds> ends_;                         ///< by mover
  std::vector<std::optional<SectorId>> switchSectors_;  ///< by mover; none of those not started
  std::vector<std::optional<Arrival>> arrivals_;        ///< by sector; none of the first
  std::vector<bool> isReached_;                         ///< by sector
  std::vector<SectorId> reached_;
};

}  // namespace hearth
