#include "light/baking/mesh_light.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "light/baking/baked_surface.h"
#include "light/baking/corner_light.h"
#include "light/baking/patch_light.h"
#include "math/parallel.h"

namespace hearth {

/// A patch, or some small faces.
struct MeshLighter::Job {
  std::size_t index;  ///< of the mesh among those that are lit
  std::uint32_t mesh;
  const LitMesh::Patch* patch;  ///< or none
  std::span<const LitMesh::SmallFace> faces;

  std::int64_t texels() const {
    return patch ? patch->surface.texels.count()
                 : std::ssize(faces) * kSmallFaceSide * kSmallFaceSide;
  }
};

struct MeshLighter::Result {
  std::optional<Lightmap> light;
  std::vector<LightCost> costs;  ///< by light
  std::size_t facingLights = 0;
};

namespace {

/// So many small faces are lit at once.
constexpr std::size_t kFacesAtOnce = 512;

/// By mesh.
std::vector<std::vector<SectorId>> sectorsOfMeshes(const Level& level) {
  std::vector<std::vector<SectorId>> sectors(level.meshes.size());
  for (const MeshInSector& at : level.meshesBySector) sectors[at.mesh].push_back(at.sector);
  return sectors;
}

/// The lightmap of a whole mesh, put together from those of its parts.
class AtlasLight {
 public:
  AtlasLight(const TexelRect& rect, int channels)
      : map_{rect,
             std::vector<std::uint8_t>(static_cast<std::size_t>(rect.count()) *
                                       static_cast<std::size_t>(channels)),
             channels} {}

  /// Of a patch, or else of small faces.
  void add(const LitMesh::Patch* patch, std::span<const LitMesh::SmallFace> faces,
           const Lightmap& light) {
    if (patch)
      addPatch(*patch, light);
    else
      addFaces(faces, light);
  }

  Lightmap taken() { return compacted(std::move(map_)); }

 private:
  void addPatch(const LitMesh::Patch& patch, const Lightmap& light) {
    const TexelRect& rect = light.rect;
    for (int j = 0; j < rect.height; ++j)
      for (int i = 0; i < rect.width; ++i)
        for (int channel = 0; channel < map_.channels; ++channel)
          texel(patch.i + i, patch.j + j, channel) =
              light.at(rect.i0 + i, rect.j0 + j, ofChannel(light, channel));
  }

  void addFaces(std::span<const LitMesh::SmallFace> faces, const Lightmap& light) {
    for (std::size_t row = 0; row < faces.size(); ++row)
      for (int channel = 0; channel < map_.channels; ++channel) {
        const auto at = [&](int corner) {
          return light.at(corner, static_cast<int>(row), ofChannel(light, channel));
        };
        const auto& [face, i, j] = faces[row];
        texel(i, j, channel) = at(0);
        texel(i + 1, j, channel) = at(1);
        texel(i, j + 1, channel) = at(2);
        texel(i + 1, j + 1, channel) =
            static_cast<std::uint8_t>(std::clamp(at(1) + at(2) - at(0), 0, 255));
      }
  }

  static int ofChannel(const Lightmap& light, int channel) {
    return light.channels == 1 ? 0 : channel;
  }

  std::uint8_t& texel(int i, int j, int channel) {
    const auto index = static_cast<std::size_t>(j) * static_cast<std::size_t>(map_.rect.width) +
                       static_cast<std::size_t>(i);
    return map_.levels[index * static_cast<std::size_t>(map_.channels) +
                       static_cast<std::size_t>(channel)];
  }

  Lightmap map_;
};

}  // namespace

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
    std::span<const LitMesh::SmallFace> left = mesh.smallFaces;
    while (!left.empty()) {
      const auto some = left.first(std::min(kFacesAtOnce, left.size()));
      jobs.push_back({i, meshes[i], nullptr, some});
      left = left.subspan(some.size());
    }
  }
  std::ranges::stable_sort(jobs, std::ranges::greater{}, &Job::texels);
  return jobs;
}

MeshLighter::Result MeshLighter::done(const Job& job, BakeProgress& progress) const {
  const MeshPlace place{job.mesh, sectors_[job.mesh], lightsOf(job.mesh)};
  if (!job.patch) {
    CornerLight corners(scene_, visibilities_, settings_.lambert, place);
    std::optional<Lightmap> light = corners.find(job.faces);
    progress.add(job.texels());
    return {std::move(light), corners.costs(), 0};
  }
  const LitSurfaces patch{job.patch->surface};
  PatchLight lit(scene_, visibilities_, settings_.lambert, place, patch);
  std::optional<Lightmap> light = bakeSurface(lit, lit.texels(), settings_, progress);
  return {std::move(light), lit.costs(), lit.facing().size()};
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
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (!results[i]) found[jobs[i].index].reset();
  std::vector<int> channels(meshes.size(), 0);  // 0 of a dark one
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::optional<MeshLight>& mesh = found[jobs[i].index];
    if (!mesh) continue;
    const auto& [light, costs, facingLights] = *results[i];
    const std::vector<std::size_t>& lights = lightsOf(jobs[i].mesh).lights();
    mesh->costs.resize(lights.size());
    for (std::size_t k = 0; k < lights.size(); ++k) mesh->costs[k] += costs[lights[k]];
    mesh->facingLights = std::max(mesh->facingLights, facingLights);
    int& most = channels[jobs[i].index];
    if (light) most = std::max(most, light->channels);
  }
  std::vector<std::optional<AtlasLight>> atlases(meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (channels[i] > 0) atlases[i].emplace(lit_[meshes[i]].texels, channels[i]);
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (atlases[jobs[i].index] && results[i]->light)
      atlases[jobs[i].index]->add(jobs[i].patch, jobs[i].faces, *results[i]->light);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (atlases[i]) found[i]->lightmap = atlases[i]->taken();
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
