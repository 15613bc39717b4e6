#include "walk/stand.h"

#include <algorithm>
#include <cmath>

#include "level/locate.h"
#include "math/tolerance.h"
#include "walk/slide.h"
#include "walk/surroundings.h"

namespace hearth {

namespace {

bool isIn(const Scene& scene, SectorId sector, Vec3 p) {
  return contains(scene, scene[sector], p, kPositionSlack);
}

/// From a sector of the column of `p` to the one that holds its height, through flat portals.
SectorId followColumn(const Scene& scene, SectorId sector, Vec3 p) {
  while (scene[sector].floor.flatPortal && p.z < scene.zFloor(scene[sector]))
    sector = sectorAcross(scene.level(), scene[*scene[sector].floor.flatPortal],
                          FlatPortalSide::Lower, p.xy());
  while (scene[sector].ceiling.flatPortal && p.z > scene.zCeiling(scene[sector]))
    sector = sectorAcross(scene.level(), scene[*scene[sector].ceiling.flatPortal],
                          FlatPortalSide::Upper, p.xy());
  return sector;
}

/// Whether the sector contains `p`, or does once the feet are raised on its floor.
bool mayStandIn(const Scene& scene, SectorId sector, Vec3 p, double zHighest) {
  const double zFloor = scene.airBottom(scene[sector], p.xy());
  const bool isRaised = zFloor > p.z && zFloor <= zHighest && !scene[sector].floor.flatPortal;
  return isIn(scene, sector, {p.x, p.y, isRaised ? zFloor : p.z});
}

/// The highest step that leaves room for the head under what is above now.
double climbLimit(const Body& body, const Stand& from, double step) {
  return std::max(from.feet.z, std::min(from.feet.z + step, from.zCap - body.height));
}

std::optional<Move> tryMove(const Scene& scene, const Body& body, const Stand& from, Vec2 motion,
                            double step) {
  const double travel = length(motion);
  const double zClimb = climbLimit(body, from, step);
  const SweepQuery query{from.feet.xy(),
                         body.radius + kSkin,
                         travel,
                         {from.feet.z, zClimb, body.height},
                         from.feet.z - body.stepHeight,
                         zClimb + body.height};
  const Surroundings around(scene, from.sector, query);
  const Slide slide = slideAlong(around.blockers(), motion, body.radius + kSkin);
  const Vec2 p = from.feet.xy() + slide.displacement;
  // Slopes lift the body as it goes, steps lift it at once.
  const double zHighest = std::max(zClimb, from.feet.z + kSteepestWalk * travel) + kSkin;
  for (const SectorId sector : around.sectors()) {
    if (!mayStandIn(scene, sector, {p.x, p.y, from.feet.z}, zHighest)) continue;
    const auto stand = standAt(scene, body, sector, {p.x, p.y, from.feet.z}, zHighest,
                               body.stepHeight + travel, body.stepHeight);
    if (stand && stand->hasRoomFor(body.height) && (from.isBuried || !stand->isBuried))
      return Move{*stand, slide.displacement, slide.collided};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Stand> standAt(const Scene& scene, const Body& body, SectorId sector, Vec3 feet,
                             double zClimb, double down, double up) {
  const double zLimit = std::max(feet.z, zClimb);
  const SweepQuery query{feet.xy(),
                         body.radius,
                         0,
                         {feet.z, zLimit, body.height},
                         feet.z - down,
                         zLimit + body.height + up};
  const Surroundings around(scene, sector, query);
  Stand stand{sector, feet, around.zSupport(), around.zCap(), around.isBuried()};
  stand.feet.z = std::max(feet.z, stand.zSupport);
  stand.sector = followColumn(scene, sector, stand.feet);
  if (!isIn(scene, stand.sector, stand.feet)) return std::nullopt;
  return stand;
}

Move movedAlong(const Scene& scene, const Body& body, const Stand& from, Vec2 motion) {
  // A step up and a beam that are met at the same moment can leave no room between them, though
  // there is room on the way to either.
  for (const double fraction : {1.0, 0.25, 0.0625})
    for (const double step : {body.stepHeight, 0.0})
      if (const auto move = tryMove(scene, body, from, fraction * motion, step)) return *move;
  return {from, {0, 0}, true};
}

Stand movedVertically(const Scene& scene, const Body& body, const Stand& from, double rise) {
  Stand to = from;
  to.feet.z += rise;
  if (rise < 0) to.feet.z = std::max(to.feet.z, std::min(from.feet.z, from.zSupport));
  if (rise > 0) to.feet.z = std::max(from.feet.z, std::min(to.feet.z, from.zCap - body.height));
  to.sector = followColumn(scene, from.sector, to.feet);
  return isIn(scene, to.sector, to.feet) ? to : from;
}

}  // namespace hearth
