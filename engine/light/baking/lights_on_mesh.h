#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/baking/light_visibility.h"
#include "light/lit_mesh.h"
#include "light/lit_surface.h"
#include "light/rays/id_set.h"
#include "light/rays/shaft.h"
#include "light/rays/sky_shaft.h"
#include "math/box3.h"

namespace hearth {

/// Around the texels of a patch, which may reach beyond its faces.
TargetBox boxOf(const LitSurface& patch);

/// Around a mesh and the texels of its patches.
Box3 boxOf(const Level& level, const LitMesh& lit);

/// The lights that may shine on a mesh, each with its shaft to the whole mesh: shafts to parts of
/// it lie within that, and rays towards suns; the sky has none. A light too far away is none of
/// them, nor one that walls hide altogether.
class LightsOnMesh {
 public:
  /// `lit` is the mesh on its texel grids, `sectors` are those that the mesh is in.
  LightsOnMesh(const Scene& scene, const LightVisibilities& visibilities, const LitMesh& lit,
               std::span<const SectorId> sectors);

  /// Indices, rising.
  const std::vector<std::size_t>& lights() const { return lights_; }
  /// Of one of these that has a place.
  const Shaft& shaftFrom(std::size_t light) const { return shafts_[placeOf(light)]; }
  /// Of one of these that is a sun.
  const SkyShaft& shaftTowards(std::size_t sun) const {
    return skyShafts_[placeOf(sun) - shafts_.size()];
  }
  /// Adds the sectors that rays of these can enter on their way to the mesh, but for the sky's.
  void addSectorsTo(SectorSet& sectors) const;

 private:
  bool mayShineOn(const Scene& scene, const LightVisibilities& visibilities, std::size_t light,
                  const ShaftTargets& targets);
  std::size_t placeOf(std::size_t light) const;

  std::vector<std::size_t> lights_;
  std::vector<Shaft> shafts_;        ///< of those of these that have a place, which come first
  std::vector<SkyShaft> skyShafts_;  ///< of the suns
};

/// A mesh among those of a level.
struct MeshPlace {
  std::uint32_t mesh;                 ///< index
  std::span<const SectorId> sectors;  ///< that it is in
  const LightsOnMesh& lights;
};

}  // namespace hearth
