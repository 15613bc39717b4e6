#pragma once

#include <span>
#include <vector>

#include "level/moved_geometry.h"
#include "walk/mover_state.h"
#include "walk/walker.h"

namespace hearth {

/// A level whose movers move, tick by tick, and what follows from their heights. Like `walked` it
/// depends on nothing but its inputs, to the bit. A tick takes no memory.
class MovingLevel {
 public:
  /// The player's use key reaches so many metres.
  static constexpr double kUseReach = 1.5;

  /// Where the level has its movers. Its geometry is that of the level as authored. Both must
  /// outlive this.
  explicit MovingLevel(const Scene& authored);
  /// With the movers at other shares, by index: at rest there, loops apart.
  MovingLevel(const Scene& authored, std::span<const double> shares);
  /// Another version of a level, whose movers are in the states of those of the same name.
  MovingLevel(const Scene& authored, const MovingLevel& before);

  /// Valid while this stays in its place.
  Scene scene() const { return moved_.scene(); }
  const Level& level() const { return moved_.level(); }
  /// By mover.
  std::span<const MoverState> movers() const { return states_; }
  std::span<const double> shares() const { return moved_.shares(); }

  /// Puts the movers into other states, by index: as they were at another tick.
  void setMovers(std::span<const MoverState> states);

  /// The walker after a hand has pushed a mover towards a share, where it then rests. In one call
  /// it moves 3.2 m at most, and it stops before it would crush the walker.
  Walker pushed(const Walker& walker, const MoverShare& towards);

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
  bool bring(std::size_t mover, double share, Walker& walker);

  MovedGeometry moved_;
  std::vector<MoverState> states_;
};

}  // namespace hearth
