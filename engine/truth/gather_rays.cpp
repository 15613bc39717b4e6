#include "truth/gather_rays.h"

#include <algorithm>
#include <cmath>

#include "level/locate.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth {

namespace {

/// Whether a point of the map is in a sector's outline, or misses it by no more than so much.
bool isOver(const Level& level, const Sector& sector, Vec2 p, double slack) {
  return contains(level, sector, p) ||
         std::ranges::any_of(level.segmentsOf(sector), [&](const Segment& wall) {
           return length(nearestOnSegment(wall.p0, wall.p1, p) - p) < slack;
         });
}

bool isInAir(const Level& level, const Sector& sector, Vec3 p, double slack) {
  return isOver(level, sector, p.xy(), slack) && p.z >= sector.authoredBottom(p.xy()) - slack &&
         p.z <= sector.authoredTop(p.xy()) + slack;
}

/// Of a point of a mesh, which may be in several: the first that it is in or, if there is none, on
/// the border of.
std::optional<SectorId> sectorAround(const Level& level, const TruthMeshes& meshes, SurfaceId mesh,
                                     Vec3 p) {
  for (const double slack : {0.0, kPositionSlack})
    for (std::size_t i = 0; i < level.sectors.size(); ++i)
      if (meshes.isIn(mesh, SectorId(i)) && isInAir(level, level.sectors[i], p, slack))
        return SectorId(i);
  return std::nullopt;
}

}  // namespace

Vec3 cosineDirection(Vec3 normal, double u, double v) {
  const Vec3 other = std::abs(normal.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 across = cross(normal, other);
  const Vec3 right = 1 / length(across) * across;
  const Vec3 up = cross(right, normal);
  const double radius = std::sqrt(u);
  const auto [s, c] = sinCosDegrees(360 * v);
  return (radius * c) * right + (radius * s) * up + std::sqrt(1 - u) * normal;
}

GatherRays::GatherRays(const Level& level, const TruthMeshes& meshes, const SurfacePoint& place)
    : level_(level),
      meshes_(meshes),
      origin_(place.point),
      sector_(place.mesh ? sectorAround(level, meshes, *place.mesh, place.point) : place.sector),
      face_(place.face) {
  if (sector_) origin_ = nudgedInside(level, level[*sector_], place.point);
}

GatherRays::GatherRays(const Level& level, const TruthMeshes& meshes, Vec3 point, SectorId sector)
    : level_(level),
      meshes_(meshes),
      origin_(nudgedInside(level, level[sector], point)),
      sector_(sector) {}

std::optional<TruthHit> GatherRays::firstMet(Vec3 direction) const {
  if (!sector_) return std::nullopt;
  return traceGather(level_, *sector_, origin_, direction,
                     meshes_.facesAhead(origin_, direction, face_));
}

bool GatherRays::seesSky(Vec3 direction) const {
  const std::optional<TruthHit> met = firstMet(direction);
  return met && isSky(met->kind);
}

}  // namespace hearth
