#include "truth/gather_rays.h"

#include "level/locate.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

bool isInAir(const Level& level, const Sector& sector, Vec3 p) {
  return contains(level, sector, p.xy()) && p.z >= sector.authoredBottom(p.xy()) - kPositionSlack &&
         p.z <= sector.authoredTop(p.xy()) + kPositionSlack;
}

/// Of a point of a mesh, which may be in several.
std::optional<SectorId> sectorAround(const Level& level, const TruthMeshes& meshes, SurfaceId mesh,
                                     Vec3 p) {
  for (std::size_t i = 0; i < level.sectors.size(); ++i)
    if (meshes.isIn(mesh, SectorId(i)) && isInAir(level, level.sectors[i], p)) return SectorId(i);
  return std::nullopt;
}

}  // namespace

GatherRays::GatherRays(const Level& level, const TruthMeshes& meshes, const SurfacePoint& place)
    : level_(level),
      meshes_(meshes),
      origin_(place.point),
      sector_(place.mesh ? sectorAround(level, meshes, *place.mesh, place.point) : place.sector),
      face_(place.face) {
  if (sector_) origin_ = nudgedInside(level, level[*sector_], place.point);
}

GatherRays::GatherRays(const Level& level, const TruthMeshes& meshes, Vec3 point, SectorId sector)
    : level_(level), meshes_(meshes), origin_(point), sector_(sector) {}

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
