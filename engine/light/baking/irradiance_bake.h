#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "level/bake_settings.h"
#include "level/scene.h"
#include "light/bake_progress.h"
#include "light/baking/light_visibility.h"
#include "light/baking/mesh_light.h"
#include "light/baking/texel_sums.h"
#include "light/gather/irradiance.h"
#include "light/lit_mesh.h"
#include "light/lit_surface.h"

namespace hearth {

/// Sums of light, piece by piece of an IrradianceBake.
struct LightOfPieces {
  std::vector<TexelSums> sums;

  /// Of the same bake; white light may be added to coloured light.
  void add(const LightOfPieces& other);
};

/// Finds the light that all surfaces of a level receive, from which light bounces: on texels of its
/// own, so that a part of a bake reflects the same as the whole.
class IrradianceBake {
 public:
  /// Of texels for a bake of `settings`. Keeps references to the scene's parts.
  IrradianceBake(const Scene& scene, const BakeSettings& settings, int threads);

  /// That it finds the light of.
  std::int64_t texels() const;

  /// Of all lights of a scene; `irradiance` is what light bounces, if any does. None after a
  /// request to stop.
  std::optional<LightOfPieces> lightOf(const Scene& scene, const Irradiance* irradiance,
                                       BakeProgress& progress, const std::stop_token& stop) const;
  Irradiance irradiance(const LightOfPieces& light) const;

 private:
  /// A surface, a patch of a mesh, or small faces of one.
  struct Piece {
    SurfaceId surface;            ///< itself, or that of the mesh
    const LitMesh::Patch* patch;  ///< or none
    std::span<const LitMesh::SmallFace> faces;

    bool isOfMesh() const { return patch || !faces.empty(); }
    std::int64_t texels(const LitSurfaces& surfaces) const;
  };

  TexelSums lightOf(const Piece& piece, const Scene& scene, const LightVisibilities& visibilities,
                    const MeshLighter& meshes, const std::stop_token& stop) const;

  Scene scene_;
  BakeSettings settings_;
  int threads_;
  LitSurfaces surfaces_;
  std::vector<LitMesh> meshes_;
  std::vector<Piece> pieces_;
};

}  // namespace hearth
