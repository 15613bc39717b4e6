#include "light/baking/surface_places.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "level/locate.h"
#include "light/ray_error.h"
#include "light/rays/raytracer.h"
#include "math/tolerance.h"

namespace hearth {

Box3 boxAround(const LitSurface& surface, const TexelRect& rect) {
  const double i0 = rect.i0;
  const double j0 = rect.j0;
  Box3 box;
  for (const double i : {i0, i0 + rect.width})
    for (const double j : {j0, j0 + rect.height}) box.add(surface.toWorld({i, j}));
  return box;
}

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
                             LightDependencies* dependencies)
    : scene_(scene),
      surfaces_(surfaces),
      id_(id),
      dependencies_(dependencies),
      placement_(surfaces, id, dependencies ? &dependencies->surfaces() : nullptr),
      mayLeaveOut_(mayHaveSamplesInMeshes(scene, surfaces, id)) {
  if (!mayLeaveOut_) return;
  const Vec3 normal = surface().normal;
  const Box3 box = boxAround(surface(), surface().texels);
  sweep_ = Raytracer(scene).pastMeshes(box.farthest(-1 * normal), normal, scene[id].sector);
  const Box3 swept = sweptFrom(box);
  for (const FaceTree& faces : scene.level().faceTrees)
    if (faces.box().meets(swept)) before_.push_back(faces.box());
}

/// All that samples in a box meet on their way past the meshes of the surface's sector.
Box3 SurfacePlaces::sweptFrom(const Box3& box) const {
  Box3 swept = box;
  swept.add(Box3{box.min + sweep_, box.max + sweep_});
  return swept.grownBy(kAuthorNoise +
                       roundingOf(largestCoordinate(swept.min) + largestCoordinate(swept.max)));
}

bool SurfacePlaces::isLeftOut(const SamplePoint& at) const {
  const Box3 swept = sweptFrom({at.target, at.target});
  const auto isOnWay = [&](const Box3& mesh) { return mesh.meets(swept); };
  // A mesh that is not on the way may come to be: then the sectors there will have changed.
  if (!dependencies_ && at.surface == id_ && std::ranges::none_of(before_, isOnWay)) return false;
  const bool isInMesh = Raytracer(scene_).isInsideMesh(
      at.target, surfaces_[at.surface.index()]->normal, scene_[at.surface].sector,
      dependencies_ ? &dependencies_->sampleSectors() : nullptr);
  if (isInMesh && dependencies_) dependencies_->addSampleInMesh();
  return isInMesh;
}

bool PatchPlaces::isLeftOut(const SamplePoint& at) const {
  return !isInAir(scene_, sectors_, at.target);
}

std::optional<SectorId> sectorAround(const Scene& scene, std::span<const SectorId> sectors,
                                     Vec3 point) {
  for (const double slack : {0.0, kPositionSlack})
    for (const SectorId sector : sectors)
      if (contains(scene, scene[sector], point, slack)) return sector;
  return std::nullopt;
}

bool isInAir(const Scene& scene, std::span<const SectorId> sectors, Vec3 point) {
  return std::ranges::any_of(sectors, [&](SectorId sector) {
    return contains(scene, scene[sector], point, kPositionSlack);
  });
}

}  // namespace hearth
