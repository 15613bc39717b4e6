#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "load/link.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Whether a point of a segment's plane lies on what a piece of its wall shows, sky apart.
bool liesOn(const Level& level, const WallPiece& piece, Vec3 p) {
  if (p.z < piece.zBottom - kInPlane || p.z > piece.zTop + kInPlane) return false;
  if (const SurfaceId* surface = std::get_if<SurfaceId>(&piece.content))
    return !isSky(level[*surface].kind);
  const Opening& opening = std::get<Opening>(piece.content);
  const Sector& next = level[opening.next];
  return (opening.floorSidewall && p.z <= next.airBottom(p.xy()) + kInPlane) ||
         (opening.ceilingSidewall && p.z >= next.airTop(p.xy()) - kInPlane) ||
         (opening.maskedMiddle && p.z >= level[*opening.maskedMiddle].zBottom - kInPlane &&
          p.z <= level[*opening.maskedMiddle].zTop + kInPlane);
}

/// The walls of a sector that a point lies on, each authored one once.
std::vector<std::string> wallsAt(const Level& level, const Sector& sector, Vec3 p) {
  std::vector<std::string> walls;
  for (const Segment& segment : level.segmentsOf(sector)) {
    if (length(nearestOnSegment(segment.p0, segment.p1, p.xy()) - p.xy()) > kInPlane) continue;
    if (std::ranges::none_of(segment.pieces,
                             [&](const WallPiece& piece) { return liesOn(level, piece, p); }))
      continue;
    const std::string wall =
        fmt::format("wall {} of loop \"{}\"", segment.wall, sector.loops[segment.loop].name);
    if (std::ranges::find(walls, wall) == walls.end()) walls.push_back(wall);
  }
  return walls;
}

}  // namespace

void validateLight(Report& report, const Level& level, Place place, const LightSource& light) {
  const Sector& sector = level[light.sector];
  const Vec3 p = light.position;
  std::vector<std::string> planes = wallsAt(level, sector, p);
  if (sector.floorSurface && !sector.floor.isSky &&
      std::abs(p.z - sector.airBottom(p.xy())) <= kInPlane)
    planes.push_back("the floor");
  if (sector.ceilingSurface && !sector.ceiling.isSky &&
      std::abs(p.z - sector.airTop(p.xy())) <= kInPlane)
    planes.push_back("the ceiling");
  if (planes.empty()) return;
  report.warning(place,
                 fmt::format("the light lies in {} of sector \"{}\", and does not light it",
                             fmt::join(planes, " and in "), sector.name),
                 "move it off that plane", "light-in-plane");
}

}  // namespace hearth
