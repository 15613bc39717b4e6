#include "light/baking/mesh_light.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "light/baking/atlas_light.h"
#include "light/baking/baked_surface.h"
#include "light/baking/corner_light.h"
#include "light/baking/patch_light.h"
#include "light/sectors_of_meshes.h"
#include "math/parallel.h"

namespace hearth {

/// A patch, or some small faces.
struct MeshLighter::Job {
  std::size_t index;  ///< of the mesh among those that are lit
  std::uint32_t mesh;
  const LitMesh::Patch* patch;  ///< or none
  std::span<const LitMesh::SmallFace> faces;

  std::int64_t texels() const {
    return patch ? patch->surface.texels.count() : texelsOfSmallFaces(faces);
  }
};

struct MeshLighter::Result {
  std::optional<Lightmap> light;
  std::vector<LightCost> costs;  ///< by light
  std::size_t facingLights = 0;
  SectorSet met;
};

MeshLighter::MeshLighter(const Scene& scene, const LightVisibilities& visibilities,
                         const BakeSettings& settings, int threads,
                         std::span<const std::uint32_t> meshes, const std::vector<LitMesh>& lit)
    : scene_(scene),
      visibilities_(visibilities),
      settings_(settings),
      threads_(threads),
      lit_(lit),
      sectors_(sectorsOfMeshes(scene.level())),
      lights_(lit.size()) {
  parallelFor(meshes.size(), threads, [&](std::size_t i) {
    const std::uint32_t mesh = meshes[i];
    lights_[mesh].emplace(scene, visibilities, lit[mesh], sectors_[mesh]);
  });
}

/// Largest first, so that no thread starts the longest job last.
std::vector<MeshLighter::Job> MeshLighter::jobsFor(std::span<const std::uint32_t> meshes) const {
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const LitMesh& mesh = lit_[meshes[i]];
    for (const LitMesh::Patch& patch : mesh.patches) jobs.push_back({i, meshes[i], &patch, {}});
    for (const auto faces : smallFacesAtOnce(mesh)) jobs.push_back({i, meshes[i], nullptr, faces});
  }
  std::ranges::stable_sort(jobs, std::ranges::greater{}, &Job::texels);
  return jobs;
}

MeshLighter::Result MeshLighter::done(const Job& job, BakeProgress& progress) const {
  const MeshPlace place = placeOf(job.mesh);
  if (!job.patch) {
    CornerLight corners(scene_, visibilities_, settings_.lambert, place);
    std::optional<Lightmap> light = corners.find(job.faces).toLightmap(1);
    progress.add(job.texels());
    return {std::move(light), corners.costs(), 0, corners.met()};
  }
  const LitSurfaces patch{job.patch->surface};
  PatchLight lit(scene_, visibilities_, settings_.lambert, place, patch);
  std::optional<Lightmap> light = bakeSurface(lit, lit.surface().texels, settings_, progress);
  return {std::move(light), lit.costs(), lit.facing().size(), lit.met()};
}

std::int64_t MeshLighter::texelsOf(std::span<const std::uint32_t> meshes) const {
  std::int64_t sum = 0;
  for (const Job& job : jobsFor(meshes)) sum += job.texels();
  return sum;
}

std::vector<std::optional<MeshLight>> MeshLighter::find(std::span<const std::uint32_t> meshes,
                                                        BakeProgress& progress,
                                                        const std::stop_token& stop) const {
  const std::vector<Job> jobs = jobsFor(meshes);
  std::vector<std::optional<Result>> results(jobs.size());
  parallelFor(jobs.size(), threads_, [&](std::size_t i) {
    if (!stop.stop_requested()) results[i] = done(jobs[i], progress);
  });

  std::vector<std::optional<MeshLight>> found(meshes.size(), MeshLight());
  std::vector<std::vector<PartOfAtlas>> parts(meshes.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::optional<MeshLight>& mesh = found[jobs[i].index];
    if (!results[i]) mesh.reset();
    if (!mesh) continue;
    auto& [light, costs, facingLights, met] = *results[i];
    const std::vector<std::size_t>& lights = lightsOf(jobs[i].mesh).lights();
    mesh->costs.resize(lights.size());
    for (std::size_t k = 0; k < lights.size(); ++k) mesh->costs[k] += costs[lights[k]];
    mesh->facingLights = std::max(mesh->facingLights, facingLights);
    mesh->met.add(met);
    parts[jobs[i].index].push_back({jobs[i].patch, jobs[i].faces, std::move(light)});
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (found[i]) found[i]->lightmap = atlasOf(lit_[meshes[i]], parts[i]);
  return found;
}

void MeshLighter::add(std::uint32_t mesh, MeshLight light, BakedLight& baked) const {
  const std::size_t surface = lit_[mesh].surface.index();
  baked.lightmaps[surface] = std::move(light.lightmap);
  if (baked.surfaceCosts.empty()) return;
  SurfaceCost& cost = baked.surfaceCosts[surface];
  cost.facingLights = light.facingLights;
  const std::vector<std::size_t>& lights = lightsOf(mesh).lights();
  for (std::size_t k = 0; k < light.costs.size(); ++k) {
    baked.lightCosts[lights[k]] += light.costs[k];
    cost.rays += light.costs[k].rays;
  }
}

}  // namespace hearth
