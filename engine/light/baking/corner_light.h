#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "light/baking/light_visibility.h"
#include "light/baking/mesh_shafts.h"
#include "light/baking/patch_light.h"
#include "light/baking/texel_sums.h"
#include "light/light_cost.h"
#include "light/lit_mesh.h"

namespace hearth {

/// The light at the corners of faces that are smaller than a texel.
class CornerLight {
 public:
  /// Keeps references to `visibilities` and `place`.
  CornerLight(const Scene& scene, const LightVisibilities& visibilities, bool lambert,
              const MeshPlace& place);

  /// The sums of a row of three texels for each face, of one sample each.
  TexelSums find(std::span<const LitMesh::SmallFace> faces);

  /// One for each light of the level, in their order.
  const std::vector<LightCost>& costs() const { return costs_; }
  /// The sectors that light of areas comes through.
  const SectorSet& met() const { return met_; }

 private:
  struct Corner {
    Vec3 point;
    std::optional<SectorId> sector;  ///< of the mesh's, around it; none if it lies in no air
  };
  /// Indices into `corners_`.
  using CornersOfFace = std::array<std::uint32_t, 3>;

  void placeCorners(std::span<const LitMesh::SmallFace> faces);
  void add(std::size_t light, std::span<const LitMesh::SmallFace> faces, TexelSums& sums);
  std::uint32_t cornerFor(const CornersOfFace& ofFace, std::size_t corner) const;
  TargetBox boxOfCorners() const;
  void addArea(std::size_t light, std::span<const LitMesh::SmallFace> faces, TexelSums& sums);
  void findAreas(std::span<const LitMesh::SmallFace> faces, std::int64_t& slices);
  std::uint32_t cornerInUse(const CornersOfFace& ofFace,
                            const std::vector<std::vector<std::size_t>>& uses) const;
  double fractionInFront(std::size_t light, const MeshFace& face, Vec3 normal) const;
  double seenFraction(std::size_t light, std::uint32_t corner);
  double seenFractionFrom(const Corner& corner, std::size_t light, std::int64_t& rays);
  const MeshFace& faceAt(const LitMesh::SmallFace& face) const {
    return scene_.level().facesOf(scene_.level().meshes[place_.mesh])[face.face];
  }

  Scene scene_;
  const LightVisibilities& visibilities_;
  bool lambert_;
  const MeshPlace& place_;
  std::vector<Corner> corners_;         ///< each place once
  std::vector<CornersOfFace> ofFaces_;  ///< in the order of the faces
  std::optional<MeshShafts> shafts_;    ///< to these
  std::vector<double> seen_;            ///< by corner, of the light at hand; below 0 if unknown
  AreaVisibility areas_;
  SectorSet met_;                ///< that light of areas comes through
  std::vector<double> ofAreas_;  ///< fractions of all, of each corner of each face; once found
  std::vector<LightCost> costs_;
};

}  // namespace hearth
