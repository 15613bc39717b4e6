#pragma once

#include <span>

#include "level/scene.h"
#include "light/lit_surface.h"
#include "light/rays/id_set.h"
#include "light/sampling/sample_placement.h"

namespace hearth {

/// Whether samples of a surface, or of what continues it, may lie inside meshes.
bool mayHaveSamplesInMeshes(const Scene& scene, const LitSurfaces& surfaces, SurfaceId id);

/// Where the samples of a surface lie, and which of them count.
class SurfacePlaces {
 public:
  /// Keeps references to `surfaces` and `sought`, which, if any, records the surfaces on which
  /// places are sought.
  SurfacePlaces(const Scene& scene, const LitSurfaces& surfaces, SurfaceId id,
                SurfaceSet* sought = nullptr);

  const LitSurface& surface() const { return *surfaces_[id_.index()]; }

  SamplePoint place(Vec2 texelPoint) const { return placement_.place(texelPoint); }
  /// Places the samples at one height, in texel coordinates.
  SamplePlacement::Row inRow(double row) const { return {placement_, row}; }

  /// Whether a sample lies inside a mesh, and so is left out of its texel.
  bool isLeftOut(const SamplePoint& at) const;
  /// False if none can be.
  bool mayLeaveOut() const { return mayLeaveOut_; }

 private:
  Scene scene_;
  const LitSurfaces& surfaces_;
  SurfaceId id_;
  SamplePlacement placement_;
  bool mayLeaveOut_;
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
  SamplePlacement::Row inRow(double row) const { return {placement_, row}; }

  /// Whether a sample lies in no air: in a wall, or beyond a flat.
  bool isLeftOut(const SamplePoint& at) const;
  bool mayLeaveOut() const { return true; }

 private:
  Scene scene_;
  std::span<const SectorId> sectors_;
  const LitSurfaces& patch_;
  SamplePlacement placement_;
};

/// Whether a point lies in the air of one of some sectors, or on its border.
bool isInAir(const Scene& scene, std::span<const SectorId> sectors, Vec3 point);

}  // namespace hearth
