#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "light/bakery.h"
#include "light/baking/light_visibility.h"
#include "light/baking/lights_on_mesh.h"
#include "light/light_cost.h"
#include "light/lightmap.h"
#include "light/rays/id_set.h"

namespace hearth {

/// What a bake finds for a mesh.
struct MeshLight {
  std::optional<Lightmap> lightmap;  ///< of all its faces
  std::vector<LightCost> costs;      ///< of its LightsOnMesh
  std::size_t facingLights = 0;      ///< the most that lie before one of its patches
  SectorSet met;                     ///< sectors that light of areas comes through
};

/// Finds the light of meshes: what is larger than a texel gets it as surfaces do, smaller faces at
/// their corners.
class MeshLighter {
 public:
  /// Of some meshes, by index. `lit` has them, on grids of `settings`. Keeps references to
  /// `visibilities`, `settings` and `lit`.
  MeshLighter(const Scene& scene, const LightVisibilities& visibilities,
              const BakeSettings& settings, int threads, std::span<const std::uint32_t> meshes,
              const std::vector<LitMesh>& lit);

  std::span<const SectorId> sectorsOf(std::uint32_t mesh) const { return sectors_[mesh]; }
  /// Of one of the meshes.
  const LightsOnMesh& lightsOf(std::uint32_t mesh) const { return *lights_[mesh]; }
  MeshPlace placeOf(std::uint32_t mesh) const { return {mesh, sectors_[mesh], lightsOf(mesh)}; }
  /// The texels that `find` counts as done.
  std::int64_t texelsOf(std::span<const std::uint32_t> meshes) const;
  /// Of some of the meshes, in their order; none where it was stopped before.
  std::vector<std::optional<MeshLight>> find(std::span<const std::uint32_t> meshes,
                                             BakeProgress& progress,
                                             const std::stop_token& stop = {}) const;
  /// Gives a mesh its light. Adds to the costs of `baked` where it has some.
  void add(std::uint32_t mesh, MeshLight light, BakedLight& baked) const;

 private:
  struct Job;
  struct Result;

  std::vector<Job> jobsFor(std::span<const std::uint32_t> meshes) const;
  Result done(const Job& job, BakeProgress& progress) const;

  Scene scene_;
  const LightVisibilities& visibilities_;
  const BakeSettings& settings_;
  int threads_;
  const std::vector<LitMesh>& lit_;
  std::vector<std::vector<SectorId>> sectors_;       ///< by mesh
  std::vector<std::optional<LightsOnMesh>> lights_;  ///< by mesh
};

}  // namespace hearth
