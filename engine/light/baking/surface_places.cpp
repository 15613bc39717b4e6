#include "light/baking/surface_places.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "level/locate.h"
#include "light/rays/raytracer.h"
#include "math/tolerance.h"

namespace hearth {

bool mayHaveSamplesInMeshes(const Scene& scene, const LitSurfaces& surfaces, SurfaceId id) {
  if (scene.level().meshes.empty()) return false;
  // A sample lies on no surface that is farther away than a few others.
  constexpr std::size_t kMany = 64;
  std::vector<SurfaceId> reached{id};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (i > kMany || !scene.level().meshesIn(scene[reached[i]].sector).empty()) return true;
    for (const Continuation& next : surfaces[reached[i].index()]->continuations)
      if (std::ranges::find(reached, next.surface) == reached.end())
        reached.push_back(next.surface);
  }
  return false;
}

SurfacePlaces::SurfacePlaces(const Scene& scene, const LitSurfaces& surfaces, SurfaceId id,
                             SurfaceSet* sought)
    : scene_(scene),
      surfaces_(surfaces),
      id_(id),
      placement_(surfaces, id, sought),
      mayLeaveOut_(mayHaveSamplesInMeshes(scene, surfaces, id)) {}

bool SurfacePlaces::isLeftOut(const SamplePoint& at) const {
  return Raytracer(scene_).isInsideMesh(at.target, surfaces_[at.surface.index()]->normal,
                                        scene_[at.surface].sector);
}

bool PatchPlaces::isLeftOut(const SamplePoint& at) const {
  return !isInAir(scene_, sectors_, at.target);
}

bool isInAir(const Scene& scene, std::span<const SectorId> sectors, Vec3 point) {
  return std::ranges::any_of(sectors, [&](SectorId sector) {
    return contains(scene, scene[sector], point, kPositionSlack);
  });
}

}  // namespace hearth
