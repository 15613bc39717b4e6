#pragma once

#include <optional>

#include "level/scene.h"
#include "walk/body.h"

namespace hearth {

/// A body's place, and the floor and ceiling there.
struct Stand {
  SectorId sector;  ///< contains `feet` within kPositionSlack
  Vec3 feet;
  double zSupport;  ///< the highest support; -infinity if there is none near below
  double zCap;      ///< the lowest ceiling above its head; +infinity if none is near

  bool isBuried = false;  ///< in something too high to step up to

  bool hasRoomFor(double height) const { return zCap + kSkin >= feet.z + height; }
};

/// The stand of a body at `feet`, raised onto its support if that is no higher than `zClimb`. Looks
/// at most `down` metres below the feet and `up` above the head. None if no linked sector contains
/// the raised feet; the given feet may be below the sector's floor.
std::optional<Stand> standAt(const Scene& scene, const Body& body, SectorId sector, Vec3 feet,
                             double zClimb, double down, double up);

struct Move {
  Stand stand;
  Vec2 displacement;
  bool collided = false;
};

/// Moves a body over the ground by `motion`, sliding along what stops it and stepping up to
/// `Body::stepHeight`. It moves less far where the way is too complicated, and not at all where the
/// body does not fit.
Move movedAlong(const Scene& scene, const Body& body, const Stand& from, Vec2 motion);

/// Moves a body up or down by `rise` until something stops it.
Stand movedVertically(const Scene& scene, const Body& body, const Stand& from, double rise);

}  // namespace hearth
