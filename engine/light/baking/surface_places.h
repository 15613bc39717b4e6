#pragma once

#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/baking/light_dependencies.h"
#include "light/lit_surface.h"
#include "light/sampling/sample_placement.h"
#include "math/box3.h"

namespace hearth {

/// Around some texels of a surface. All its samples lie in the box around all of its texels, within
/// tolerances.
Box3 boxAround(const LitSurface& surface, const TexelRect& texels);

/// Whether samples of a surface, or of what continues it, may lie inside meshes.
bool mayHaveSamplesInMeshes(const Scene& scene, const LitSurfaces& surfaces, SurfaceId id);

/// Where the samples of a surface lie, and which of them count.
class SurfacePlaces {
 public:
  /// Keeps references to `surfaces` and `dependencies`, which, if any, records what the places
  /// depend on.
  SurfacePlaces(const Scene& scene, const LitSurfaces& surfaces, SurfaceId id,
                LightDependencies* dependencies = nullptr);

  const LitSurface& surface() const { return *surfaces_[id_.index()]; }

  SamplePoint place(Vec2 texelPoint) const { return placement_.place(texelPoint); }
  /// Places samples row by row.
  SamplePlacement::Rows inRows() const { return SamplePlacement::Rows(placement_); }

  /// Whether a sample lies inside a mesh, and so is left out of its texel.
  bool isLeftOut(const SamplePoint& at) const;
  /// False if none can be.
  bool mayLeaveOut() const { return mayLeaveOut_; }

 private:
  Box3 sweptFrom(const Box3& box) const;

  Scene scene_;
  const LitSurfaces& surfaces_;
  SurfaceId id_;
  LightDependencies* dependencies_;
  SamplePlacement placement_;
  bool mayLeaveOut_;
  Vec3 sweep_{};              ///< along the normal, past all meshes in the surface's sector
  std::vector<Box3> before_;  ///< around the meshes that a sample of the surface meets on that way
};

/// The same for a patch of a mesh.
class PatchPlaces {
 public:
  /// `sectors` are those that the mesh is in. Keeps references to these and to `patch`, which is
  /// one surface.
  PatchPlaces(const Scene& scene, std::span<const SectorId> sectors, const LitSurfaces& patch)
      : scene_(scene), sectors_(sectors), patch_(patch), placement_(patch, SurfaceId(0)) {}

  const LitSurface& surface() const { return *patch_.front(); }

  SamplePoint place(Vec2 texelPoint) const { return placement_.place(texelPoint); }
  SamplePlacement::Rows inRows() const { return SamplePlacement::Rows(placement_); }

  /// Whether a sample lies in no air: in a wall, or beyond a flat.
  bool isLeftOut(const SamplePoint& at) const;
  bool mayLeaveOut() const { return true; }

 private:
  Scene scene_;
  std::span<const SectorId> sectors_;
  const LitSurfaces& patch_;
  SamplePlacement placement_;
};

/// The first of some sectors in whose air a point lies; if there is none, the first on the border
/// of whose air it does.
std::optional<SectorId> sectorAround(const Scene& scene, std::span<const SectorId> sectors,
                                     Vec3 point);
/// Whether there is such a sector.
bool isInAir(const Scene& scene, std::span<const SectorId> sectors, Vec3 point);

}  // namespace hearth
