#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "level/locate.h"
#include "level/scene.h"
#include "walk/body.h"
#include "walk/passage.h"

namespace hearth {

/// A line that stops a body from the front of a -> b, or a disc round `a`, which may be a point.
/// Relative to SweepQuery::center, in metres.
struct Blocker {
  Vec2 a;
  Vec2 b;
  /// A corner stops only with its point `a`, and only a body behind a -> b. Overlapping sectors can
  /// put more than 360 degrees of air round a vertex. From some of this air no wall at the vertex
  /// faces the body, so no wall would stop it.
  bool isCorner = false;
  double radius = 0;  ///< of the disc; 0 of a line
};

/// A body and how far to look round it.
struct SweepQuery {
  Vec2 center;
  double radius;  ///< of the disc
  double travel;  ///< that the disc may move from `center`
  UprightBody body;
  double zLow;   ///< the lowest that the feet may come to ...
  double zHigh;  ///< ... and the highest that the head may: flat portals between are followed
};

/// What a body at `center` meets within reach. The search follows links from its sector, through
/// openings that the body fits through. So sectors that merely overlap in space are left out, and a
/// wall stops only a body in front of it. Solid things stop it where they reach into a sector that
/// is found.
class Surroundings {
 public:
  Surroundings(const Scene& scene, SectorId from, const SweepQuery& query);
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  /// In breadth-first order from `from`.
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
  void visitSector(const Sector& sector);
  template <typename Visit>
  void forEachWallInReach(const Sector& sector, Visit&& visit) const;
  void visitWall(const Segment& segment);
  void visitVertex(const Segment& before, const Segment& after);
  void visitWallBelow(const Segment& segment, Interval chord);
  void visitWallAbove(const Segment& segment, Interval chord);
  void visitBody(std::uint32_t index);
  void addFlats(const Sector& sector);
  bool isBelow(const Sector& sector) const;
  bool isAbove(const Sector& sector) const;
  bool isOpenAt(const Segment& segment, double fraction);
  void followFlat(FlatPortalId id, FlatPortalSide to);
  bool touches(const Sector& sector) const;
  void addSupport(double z);
  void block(const Segment& segment, Interval chord);
  void block(const ThingBody& body);
  void addSlopes(const Sector& sector);
  void blockWhereAbove0(const Sector& sector, double valueAtCenter, Vec2 gradient);
  double highest(const Sector& sector, const Slope& slope, double sign) const;

  // Enough for what is near a player as a rule, so that a tick takes no memory from the heap.
  std::array<std::byte, 65536> buffer_;
  std::pmr::monotonic_buffer_resource arena_{buffer_.data(), buffer_.size()};

  Scene scene_;
  SweepQuery query_;
  double sweptRadius_;  // of the disc with its travel
  std::pmr::vector<SectorId> sectors_{&arena_};
  std::pmr::vector<Blocker> blockers_{&arena_};
  std::pmr::vector<std::uint32_t> bodies_{&arena_};  // within reach: indices
  std::pmr::vector<Passage> passages_{&arena_};      // of the wall that is looked at
  std::pmr::vector<Interval> open_{&arena_};
  double zSupport_ = -kInfinity;
  bool isBuried_ = false;
  double zCap_ = kInfinity;
};

}  // namespace hearth
