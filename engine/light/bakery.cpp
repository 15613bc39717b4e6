#include "light/bakery.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>
#include <utility>

#include "light/baking/baked_surface.h"
#include "light/baking/bounces.h"
#include "light/baking/mesh_light.h"
#include "light/baking/sprite_light.h"
#include "light/grid/texel_limits.h"
#include "math/parallel.h"

namespace hearth {

namespace {

/// Puts the largest job first, so that no thread starts the longest job last.
void sortByFallingSize(std::vector<SurfaceTexels>& jobs) {
  std::ranges::stable_sort(jobs, std::ranges::greater{},
                           [](const SurfaceTexels& job) { return job.texels.count(); });
}

/// Returns the number of rays that it added.
std::int64_t addTo(std::vector<LightCost>& sum, const std::vector<LightCost>& costs) {
  std::int64_t rays = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    sum[i] += costs[i];
    rays += costs[i].rays;
  }
  return rays;
}

std::int64_t texelsOf(const std::vector<SurfaceTexels>& jobs) {
  std::int64_t sum = 0;
  for (const SurfaceTexels& job : jobs) sum += job.texels.count();
  return sum;
}

/// Indices of meshes that have some faces, which rise.
std::vector<std::uint32_t> meshesOf(const Level& level, const std::vector<std::uint32_t>& faces) {
  std::vector<std::uint32_t> meshes;
  for (std::uint32_t i = 0; i < level.meshes.size(); ++i) {
    const Mesh& mesh = level.meshes[i];
    const auto first = std::ranges::lower_bound(faces, mesh.firstFace);
    if (first != faces.end() && *first < mesh.firstFace + mesh.faceCount) meshes.push_back(i);
  }
  return meshes;
}

/// Bakes the texels of these surfaces, all of which can be lit, and `meshes`, the indices of those
/// that `litMeshes` has.
BakedLight bakeJobs(std::vector<SurfaceTexels> jobs, std::span<const std::uint32_t> meshes,
                    LitSurfaces surfaces, std::vector<LitMesh> litMeshes, const Scene& unbounced,
                    const BakeSettings& settings, int threads, BakeProgress* progress) {
  BakeProgress unwatched;
  BakeProgress& done = progress ? *progress : unwatched;
  sortByFallingSize(jobs);

  BakedLight baked;
  baked.surfaces = std::move(surfaces);
  baked.meshes = std::move(litMeshes);
  baked.lightmaps.resize(baked.surfaces.size());
  baked.surfaceCosts.resize(baked.surfaces.size());
  Bounces bounces(unbounced, settings, threads);
  const Scene scene = bounces.scene();
  baked.lightCosts.resize(scene.lights().size());
  const LightVisibilities visibilities(scene, settings, LightVisibilities::Purpose::Bake,
                                       [&] { return bounces.irradiance(); });
  const MeshLighter lighter(scene, visibilities, settings, threads, meshes, baked.meshes);
  done.begin(texelsOf(jobs) + lighter.texelsOf(meshes));
  if (!jobs.empty() || !meshes.empty() || !scene.level().sprites.empty()) bounces.find(done);
  std::mutex lightCostsMutex;
  parallelFor(jobs.size(), threads, [&](std::size_t job) {
    const auto& [id, texels] = jobs[job];
    const std::size_t i = id.index();
    SurfaceLight surface(scene, baked.surfaces, visibilities, settings.lambert, id);
    for (const std::size_t light : surface.facing()) visibilities.prefetchBeams(light);
    baked.lightmaps[i] = bakeSurface(surface, texels, settings, done);
    const std::scoped_lock lock(lightCostsMutex);
    baked.surfaceCosts[i] = {surface.facing().size(), addTo(baked.lightCosts, surface.costs())};
  });
  lightSprites(scene, visibilities, threads, baked);
  auto lightOfMeshes = lighter.find(meshes, done);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    lighter.add(meshes[i], *std::move(lightOfMeshes[i]), baked);
  baked.stats = statsOf(baked);
  return baked;
}

std::optional<std::string> mistakeInSquare(int number) {
  const double side = std::max(1.0, std::round(std::sqrt(std::max(number, 1))));
  if (side * side == number) return std::nullopt;
  return fmt::format("{} is no square number, try {}", number, side * side);
}

}  // namespace

BakeStats statsOf(const BakedLight& baked) {
  BakeStats stats;
  const auto add = [&](std::size_t surface, const TexelRect& texels) {
    ++stats.surfaces;
    stats.texels += texels.count();
    if (!baked.surfaceCosts.empty()) stats.rays += baked.surfaceCosts[surface].rays;
    const std::optional<Lightmap>& lightmap = baked.lightmaps[surface];
    if (!lightmap) return;
    ++stats.litSurfaces;
    if (lightmap->channels == 3) ++stats.coloredSurfaces;
    stats.bytes += static_cast<std::int64_t>(lightmap->bytes());
  };
  for (std::size_t i = 0; i < baked.surfaces.size(); ++i)
    if (baked.surfaces[i]) add(i, baked.surfaces[i]->texels);
  for (const LitMesh& mesh : baked.meshes)
    if (!mesh.places.empty()) add(mesh.surface.index(), mesh.texels);
  return stats;
}

std::optional<std::string> mistakeInSettings(const Scene& scene, const BakeSettings& settings) {
  if (const auto mistake = mistakeInSquare(settings.samples.value_or(1)))
    return fmt::format("samples: {}", *mistake);
  if (settings.softSamples != 0)
    if (const auto mistake = mistakeInSquare(settings.softSamples))
      return fmt::format("soft-samples: {}", *mistake);
  if (!(settings.cutOff >= 0)) return fmt::format("cut-off: {} is less than 0", settings.cutOff);
  if (!(settings.gatherError > 0))
    return fmt::format("gather-error: {} is not more than 0", settings.gatherError);
  if (const auto mistake = mistakeInTexel(scene, settings.texel))
    return fmt::format("texel: {}", *mistake);
  return std::nullopt;
}

BakedLight bake(const Scene& scene, const BakeSettings& settings, int threads,
                BakeProgress* progress) {
  LitSurfaces surfaces = makeLitSurfaces(scene, settings.texel);
  std::vector<SurfaceTexels> all;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i]) all.push_back({SurfaceId(i), surfaces[i]->texels});
  std::vector<std::uint32_t> meshes(scene.level().meshes.size());
  std::iota(meshes.begin(), meshes.end(), 0U);
  return bakeJobs(std::move(all), meshes, std::move(surfaces),
                  makeLitMeshes(scene.level(), settings.texel, threads), scene, settings, threads,
                  progress);
}

BakedLight bakeOnly(const WantedTexels& wanted, LitSurfaces surfaces, const Scene& scene,
                    const BakeSettings& settings, int threads, BakeProgress* progress) {
  const Level& level = scene.level();
  std::vector<SurfaceTexels> jobs;
  for (const SurfaceTexels& texels : wanted.surfaces)
    jobs.push_back({texels.surface, texelsToBake(texels, scene, surfaces)});
  const std::vector<std::uint32_t> meshes = meshesOf(level, wanted.faces);
  std::vector<LitMesh> lit = makeLitMeshes(level, settings.texel, meshes, threads);
  for (const std::uint32_t mesh : meshes) keepOnly(wanted.faces, level.meshes[mesh], lit[mesh]);
  return bakeJobs(std::move(jobs), meshes, std::move(surfaces), std::move(lit), scene, settings,
                  threads, progress);
}

}  // namespace hearth
