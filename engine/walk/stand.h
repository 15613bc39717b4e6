#pragma once

#include <optional>

#include "level/scene.h"
#include "walk/body.h"

namespace hearth {

/// A body's place, and what is below and above it there.
struct Stand {
  SectorId sector;  ///< contains `feet` within kPositionSlack
  Vec3 feet;
  double zSupport;  ///< the highest that bears it; -infinity where nothing does near below
  double zCap;      ///< the lowest above its head; +infinity where nothing is near above

  bool isBuried = false;  ///< in something too high to step up to

  bool hasRoomFor(double height) const { return zCap + kSkin >= feet.z + height; }
};

/// What is round a body at `feet`, raised on what bears it where that is no higher than `zClimb`.
/// Nothing is known farther below the feet than `down` metres, above the head than `up`. None where
/// no linked sector contains the raised feet; those given may be below the sector's floor.
std::optional<Stand> standAt(const Scene& scene, const Body& body, SectorId sector, Vec3 feet,
                             double zClimb, double down, double up);

struct Move {
  Stand stand;
  Vec2 moved;
  bool wasStopped = false;
};

/// Moves a body over the ground by `motion`, sliding along what stops it and stepping up to
/// `Body::step`. Where the way is too complicated, less far, and where it does not fit, not at all.
Move movedAlong(const Scene& scene, const Body& body, const Stand& from, Vec2 motion);

/// Moves a body up or down by `rise` until something stops it.
Stand risen(const Scene& scene, const Body& body, const Stand& from, double rise);

}  // namespace hearth
