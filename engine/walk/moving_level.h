#pragma once

#include <span>
#include <vector>

#include "level/scene.h"
#include "walk/mover_state.h"
#include "walk/walker.h"

namespace hearth {

/// A level whose movers move, tick by tick, and what follows from their heights. Like `walked` it
/// depends on nothing but its inputs, to the bit. A tick takes no memory.
class MovingLevel {
 public:
  /// The player's use key reaches so many metres.
  static constexpr double kUseReach = 1.5;

  /// `geometry` is that of the level as authored. The level must outlive this.
  MovingLevel(const Level& level, const Geometry& geometry);

  const Level& level() const { return *level_; }
  Scene scene() const { return {*level_, geometry_}; }
  /// By mover.
  std::span<const MoverState> movers() const { return states_; }

  /// One tick. First the use key starts movers; then all movers move, those with floors under the
  /// walker carry it, and those for which it leaves no room turn back; then it walks, and starts
  /// what it crosses or enters.
  Walker ticked(const Walker& walker, const WalkInput& input);

 private:
  void start(std::size_t mover);
  void startUsed(const Walker& walker);
  bool startAt(const Segment& segment);
  bool startOf(SectorId sector);
  void startCrossed(const Walker& before, const Walker& after);
  void startEntered(const Walker& walker);
  void move(std::size_t mover, Walker& walker);
  void setShare(std::size_t mover, double share);

  const Level* level_;
  Geometry geometry_;
  std::vector<MoverState> states_;
  std::vector<MovedFlats> moved_;  ///< of the mover that moves
};

}  // namespace hearth
