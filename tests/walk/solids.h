#pragma once

#include <optional>
#include <vector>

#include "walk/body.h"
#include "walk/walker.h"

/// What a level says is solid, found in the plainest way: a level line out of the body's axis,
/// followed from sector to sector as light would go. It shares only level/ with the walker.
namespace hearth::random_walks {

class Solids {
 public:
  explicit Solids(const Scene& scene);

  /// How many metres of the level line from `from`, which the sector contains, along a direction of
  /// unit length are in the air: `length` at most.
  double freeAlong(SectorId sector, Vec3 from, Vec2 direction, double length) const;

  /// The sector of `to`, both at one height, straight on from `from`; none where it is solid.
  std::optional<SectorId> sectorAlong(SectorId sector, Vec3 from, Vec3 to) const;

  /// Whether a wall within `radius` of `p` opens to other heights from behind. Only the
  /// geometry on the side of its axis blocks a body there, and it may be in that of the other side.
  bool isBesideOneWay(Vec2 p, double radius) const;

  /// From a sector of the column of `p` to the one that has its height. The first of `sector`'s
  /// own where nothing leads there.
  SectorId inColumn(SectorId sector, Vec3 p) const;

  /// Whether the cylinder of `body` on `feet` is in the air: along so many even directions,
  /// straight to every wall and past both sides of every vertex, where a spike could stand between
  /// these; at five heights, and beside every piece of every wall.
  bool isFree(SectorId sector, Vec3 feet, const Body& body, int directions) const;

 private:
  struct Line {
    double free;
    SectorId end;
  };
  Line follow(SectorId sector, Vec3 from, Vec2 direction, double length) const;
  std::vector<const Segment*> wallsWithin(Vec2 p, double radius) const;

  Scene scene_;
  std::vector<SegmentId> oneWays_;
};

}  // namespace hearth::random_walks
