#pragma once

#include <optional>
#include <vector>

#include "level/level.h"
#include "lint/passages.h"

namespace hearth::test {

/// A spot on the map.
struct Spot {
  SectorId sector;
  Vec2 place;
};

/// The point of a wall that is nearest, on the map.
Vec2 nearestOf(const Segment& segment, Vec2 p);

/// The movers that must be started on the way from the player's start to the first of some spots
/// that can be come to, in an order in which the switches of each can. None where there is no way.
std::optional<std::vector<std::size_t>> moversOnTheWay(const Level& level, const Passages& passages,
                                                       const std::vector<Spot>& spots);

/// Where a place in front of a wall is come to: in its sector, and in those beside it, from which
/// the use key may reach.
std::vector<Spot> spotsAt(const Level& level, SectorId sector, Vec2 place);

/// At the walls that start a mover.
std::vector<Spot> spotsToStart(const Level& level, std::size_t mover);

/// How far it is to the nearest of some spots, from portal to portal.
class Distances {
 public:
  /// Through what can be passed with movers at these ends.
  Distances(const Level& level, const Passages& passages, std::vector<Spot> spots,
            std::vector<MoverEnds> ends);

  /// Metres; infinite where there is no way.
  double from(const Spot& spot) const;

 private:
  /// Within the sector of the spot.
  double within(const Spot& spot) const;
  void spread(const Passages& passages);

  const Level& level_;
  std::vector<Spot> spots_;
  std::vector<MoverEnds> ends_;  ///< by mover
  std::vector<double> through_;  ///< by segment: from its middle and through it
};

}  // namespace hearth::test
