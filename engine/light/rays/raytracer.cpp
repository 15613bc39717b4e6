#include "light/rays/raytracer.h"

#include <algorithm>
#include <optional>

#include "level/locate.h"
#include "light/ray_error.h"
#include "light/rays/ray_walk.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Metres. Beyond all of a level, and the same for all levels: no ray depends on how large its
/// level is.
constexpr double kToSky = kPreciseReach;

/// Metres from a point of a face within which no mesh stops a ray from there along `way`: as much
/// as rounding may move its crossing with the face itself.
double slackAt(const FacePoint& point, Vec3 way) {
  const double rounding = roundingOf(largestCoordinate(point.point) + length(way)) * length(way);
  return kArrival + rounding / dot(point.normal, way);
}

}  // namespace

Raytracer::Source Raytracer::sourceOf(const Scene& scene, const LightSource& light) {
  const Sector& sector = scene[light.sector];
  const Vec3 inside = nudgedInside(scene, sector, light.position);
  const bool aboveSky = sector.ceiling.isSky && light.position.z > scene.zCeiling(sector);
  const bool belowSky = sector.floor.isSky && light.position.z < scene.zFloor(sector);
  return {{inside.x, inside.y, aboveSky || belowSky ? light.position.z : inside.z}, light.sector};
}

bool Raytracer::sees(const Source& source, Vec3 target, SectorId sector, SectorSet* met) const {
  return RayWalk(scene_, AllWalls{scene_}, source, target - source.position, solidMaskedMiddles_,
                 met)
      .arrivesAt(sector, kArrival);
}

bool Raytracer::sees(const Source& source, Vec3 target, SectorId sector, const Shaft& shaft) const {
  RayWalk walk(scene_, ShaftWalls<Shaft>{shaft}, source, target - source.position,
               solidMaskedMiddles_, nullptr);
  if (shaft.gate()) walk.passGate(*shaft.gate());
  const std::optional<bool> passes = walk.passesFacesOf(shaft, kArrival);
  if (passes && (!*passes || shaft.isOpenButForFaces())) return *passes;
  return walk.arrivesAt(sector, passes ? kThroughMeshes : kArrival);
}

std::optional<SectorId> Raytracer::sectorAt(const Source& source, Vec3 point,
                                            SectorSet* met) const {
  return RayWalk(scene_, AllWalls{scene_}, source, point - source.position, solidMaskedMiddles_,
                 met)
      .sectorAtEnd(0, kThroughMeshes);
}

bool Raytracer::reaches(const Source& source, Vec3 point, SectorId sector) const {
  return RayWalk(scene_, AllWalls{scene_}, source, point - source.position, solidMaskedMiddles_,
                 nullptr)
             .sectorAtEnd(0, kArrival) == sector;
}

bool Raytracer::sees(const Source& source, const FacePoint& target, const Shaft& shaft) const {
  const double slack = slackAt(target, source.position - target.point);
  RayWalk walk(scene_, ShaftWalls<Shaft>{shaft}, source, target.point - source.position,
               solidMaskedMiddles_, nullptr);
  if (shaft.gate()) walk.passGate(*shaft.gate());
  const std::optional<bool> passes = walk.passesFacesOf(shaft, slack);
  if (passes && (!*passes || shaft.isOpenButForFaces())) return *passes;
  const std::optional<SectorId> arrived = walk.sectorAtEnd(slack, passes ? kThroughMeshes : slack);
  return arrived &&
         std::ranges::any_of(scene_.level().meshesIn(*arrived),
                             [&](const MeshInSector& at) { return at.mesh == target.mesh; });
}

bool Raytracer::seesSky(const Source& point, Vec3 direction, SectorSet* met) const {
  return RayWalk(scene_, AllWalls{scene_}, point, direction, solidMaskedMiddles_, met, kToSky)
      .endsInSky(kArrival);
}

bool Raytracer::seesSky(const Source& point, Vec3 direction, const SkyShaft& shaft) const {
  return RayWalk(scene_, ShaftWalls<SkyShaft>{shaft}, point, direction, solidMaskedMiddles_,
                 nullptr, kToSky)
      .endsInSky(kArrival);
}

bool Raytracer::seesSky(const Source& start, const FacePoint& point, Vec3 direction,
                        const SkyShaft& shaft) const {
  return RayWalk(scene_, ShaftWalls<SkyShaft>{shaft}, start, direction, solidMaskedMiddles_,
                 nullptr, kToSky)
      .endsInSky(slackAt(point, direction));
}

Vec3 Raytracer::pastMeshes(Vec3 point, Vec3 normal, SectorId sector) const {
  double reach = 0;
  for (const MeshInSector& at : scene_.level().meshesIn(sector)) {
    const Vec3 farthest = scene_.level().faceTrees[at.mesh].box().farthest(normal);
    reach = std::max(reach, dot(normal, farthest - point));
  }
  return reach <= kArrival ? Vec3{} : (2 * reach) * normal;
}

bool Raytracer::isInsideMesh(Vec3 point, Vec3 normal, SectorId sector, SectorSet* met) const {
  const Vec3 way = pastMeshes(point, normal, sector);
  if (way == Vec3{}) return false;
  return RayWalk(scene_, AllWalls{scene_}, {point, sector}, way, solidMaskedMiddles_, met)
      .meetsBackFirst();
}

}  // namespace hearth
