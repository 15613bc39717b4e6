#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>
#include <vector>

#include "level/locate.h"
#include "level/scene.h"
#include "walk/body.h"
#include "walk/passage.h"

namespace hearth {

/// A line that stops a body from the front of a -> b. Relative to Reach::center, in metres.
struct Blocker {
  Vec2 a;
  Vec2 b;
  /// Then it is `a` alone, and stops a body behind a -> b. Where sectors overlap, more than 360
  /// degrees of air can meet in a vertex, and from some of them no wall there is seen from its
  /// front: not before the body is past it, and in it.
  bool isCorner = false;
};

/// How far to look round a body.
struct Reach {
  Vec2 center;
  double radius;  ///< of the disc
  double travel;  ///< that the disc may move from `center`
  UprightBody body;
  double zLow;   ///< the lowest that the feet may come to ...
  double zHigh;  ///< ... and the highest that the head may: flat portals between are followed
};

/// What a body at `center` meets within reach. The search follows links from its sector, through
/// openings that the body fits through. So sectors that merely overlap in space are left out, and a
/// wall stops only a body in front of it.
class Surroundings {
 public:
  Surroundings(const Scene& scene, SectorId from, const Reach& reach);
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  /// `from` first, the others by rising number of links to it.
  const std::pmr::vector<SectorId>& sectors() const { return sectors_; }
  const std::pmr::vector<Blocker>& blockers() const { return blockers_; }
  /// The highest support within reach that the feet can step up to; -infinity if there is none.
  double zSupport() const { return zSupport_; }
  /// Whether a support within reach is too high to step up to.
  bool isBuried() const { return isBuried_; }
  /// The lowest ceiling above the head.
  double zCap() const { return zCap_; }

 private:
  void add(SectorId sector);
  void lookRound(const Sector& sector);
  void lookAtWall(const Segment& segment);
  void lookAtVertex(const Segment& before, const Segment& after);
  void lookAtWallBelow(const Segment& segment, Interval chord);
  void lookAtWallAbove(const Segment& segment, Interval chord);
  void takeFlats(const Sector& sector);
  bool isBelow(const Sector& sector) const;
  bool isAbove(const Sector& sector) const;
  bool isOpenAt(const Segment& segment, double fraction);
  void followFlat(FlatPortalId id, FlatPortalSide to);
  bool touches(const Sector& sector) const;
  void bear(double z);
  void block(const Segment& segment, Interval chord);
  void takeSlopes(const Sector& sector);
  void blockWhereAbove0(const Sector& sector, double valueAtCenter, Vec2 gradient);
  double highest(const Sector& sector, const Slope& slope, double sign) const;

  // Enough for what is near a player as a rule, so that a tick takes no memory from the heap.
  std::array<std::byte, 16384> buffer_;
  std::pmr::monotonic_buffer_resource arena_{buffer_.data(), buffer_.size()};

  Scene scene_;
  Reach reach_;
  double radius_;  // of all that the disc can come to
  std::pmr::vector<SectorId> sectors_{&arena_};
  std::pmr::vector<Blocker> blockers_{&arena_};
  std::pmr::vector<Passage> passages_{&arena_};  // of the wall that is looked at
  std::pmr::vector<Interval> open_{&arena_};
  double zSupport_ = -kNowhere;
  bool isBuried_ = false;
  double zCap_ = kNowhere;
};

}  // namespace hearth
