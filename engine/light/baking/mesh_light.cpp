#include "light/baking/mesh_light.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "light/baking/baked_surface.h"
#include "light/baking/corner_light.h"
#include "light/baking/patch_light.h"
#include "math/parallel.h"

namespace hearth {

namespace {

/// So many small faces are lit at once.
constexpr std::size_t kFacesAtOnce = 512;

/// A patch, or some small faces.
struct MeshJob {
  std::uint32_t mesh;
  const LitMesh::Patch* patch;  ///< or none
  std::span<const LitMesh::SmallFace> faces;

  std::int64_t size() const {
    return patch ? patch->surface.texels.count() : 3 * std::ssize(faces);
  }
};

struct MeshJobResult {
  std::optional<Lightmap> light;
  std::vector<LightCost> costs;
  std::size_t facingLights = 0;
};

/// Largest first, so that no thread starts the longest job last.
std::vector<MeshJob> jobsFor(std::span<const std::uint32_t> meshes,
                             const std::vector<LitMesh>& lit) {
  std::vector<MeshJob> jobs;
  for (const std::uint32_t mesh : meshes) {
    for (const LitMesh::Patch& patch : lit[mesh].patches) jobs.push_back({mesh, &patch, {}});
    std::span<const LitMesh::SmallFace> left = lit[mesh].smallFaces;
    while (!left.empty()) {
      const auto some = left.first(std::min(kFacesAtOnce, left.size()));
      jobs.push_back({mesh, nullptr, some});
      left = left.subspan(some.size());
    }
  }
  std::ranges::stable_sort(jobs, std::ranges::greater{}, &MeshJob::size);
  return jobs;
}

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

  void add(const MeshJob& job, const Lightmap& light) {
    if (job.patch)
      addPatch(*job.patch, light);
    else
      addFaces(job.faces, light);
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

class MeshLighter {
 public:
  MeshLighter(const Scene& scene, const LightVisibilities& visibilities,
              const BakeSettings& settings)
      : scene_(scene),
        visibilities_(visibilities),
        settings_(settings),
        sectors_(sectorsOfMeshes(scene.level())) {}

  MeshJobResult done(const MeshJob& job) const {
    const MeshPlace place{job.mesh, sectors_[job.mesh]};
    if (!job.patch) {
      CornerLight corners(scene_, visibilities_, settings_.lambert, place);
      std::optional<Lightmap> light = corners.find(job.faces);
      return {std::move(light), corners.costs(), 0};
    }
    const LitSurfaces patch{job.patch->surface};
    PatchLight lit(scene_, visibilities_, settings_.lambert, place, patch);
    BakeProgress unwatched;
    std::optional<Lightmap> light = bakeSurface(lit, lit.texels(), settings_, unwatched);
    return {std::move(light), lit.costs(), lit.facing().size()};
  }

 private:
  Scene scene_;
  const LightVisibilities& visibilities_;
  const BakeSettings& settings_;
  std::vector<std::vector<SectorId>> sectors_;
};

void addCosts(SurfaceId surface, const MeshJobResult& result, BakedLight& baked) {
  if (baked.surfaceCosts.empty()) return;
  SurfaceCost& cost = baked.surfaceCosts[surface.index()];
  cost.facingLights = std::max(cost.facingLights, result.facingLights);
  for (std::size_t i = 0; i < result.costs.size(); ++i) {
    baked.lightCosts[i] += result.costs[i];
    cost.rays += result.costs[i].rays;
  }
}

}  // namespace

void lightMeshes(const Scene& scene, const LightVisibilities& visibilities,
                 const BakeSettings& settings, int threads, std::span<const std::uint32_t> meshes,
                 BakedLight& baked) {
  const std::vector<MeshJob> jobs = jobsFor(meshes, baked.meshes);
  const MeshLighter lighter(scene, visibilities, settings);
  std::vector<MeshJobResult> results(jobs.size());
  parallelFor(jobs.size(), threads, [&](std::size_t i) { results[i] = lighter.done(jobs[i]); });

  std::vector<int> channels(baked.meshes.size(), 0);  // 0 of a dark one
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    int& most = channels[jobs[i].mesh];
    if (results[i].light) most = std::max(most, results[i].light->channels);
    addCosts(baked.meshes[jobs[i].mesh].surface, results[i], baked);
  }
  std::vector<std::optional<AtlasLight>> atlases(baked.meshes.size());
  for (const std::uint32_t mesh : meshes)
    if (channels[mesh] > 0) atlases[mesh].emplace(baked.meshes[mesh].texels, channels[mesh]);
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (results[i].light) atlases[jobs[i].mesh]->add(jobs[i], *results[i].light);
  for (const std::uint32_t mesh : meshes)
    if (atlases[mesh]) baked.lightmaps[baked.meshes[mesh].surface.index()] = atlases[mesh]->taken();
}

}  // namespace hearth
