#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "level/scene.h"
#include "light/baking/area_lattice.h"
#include "light/baking/light_visibility.h"
#include "light/baking/lights_on_mesh.h"
#include "light/baking/mesh_shafts.h"
#include "light/baking/surface_places.h"
#include "light/light_cost.h"
#include "light/lit_surface.h"
#include "light/sampling/sample_placement.h"

namespace hearth {

/// A lattice of samples, row by row.
class PatchSamples {
 public:
  PatchSamples(std::vector<SamplePoint> samples, int columns)
      : samples_(std::move(samples)), columns_(columns) {}

  const std::vector<SamplePoint>& samples() const { return samples_; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

 private:
  std::vector<SamplePoint> samples_;
  int columns_;
};

/// The light that arrives at points of a patch of a mesh: as SurfaceLight, but by rays
/// alone, of one shaft for each light.
class PatchLight : public PatchPlaces {
 public:
  using Blocks = PatchSamples;

  /// Keeps references to all but `scene`.
  PatchLight(const Scene& scene, const LightVisibilities& visibilities, bool lambert,
             const MeshPlace& place, const LitSurfaces& patch);
  PatchLight(const PatchLight&) = delete;
  PatchLight& operator=(const PatchLight&) = delete;

  const std::vector<std::size_t>& facing() const { return facing_; }
  const LightSource& light(std::size_t index) const { return scene_.lights()[index]; }
  bool isSoft(std::size_t light) const { return visibilities_.reach.isSoft(light); }
  int channels() const;

  PatchSamples inBlocks(std::vector<SamplePoint> samples, int columns) const {
    return {std::move(samples), columns};
  }

  std::span<const std::size_t> reaching(const PatchSamples&,
                                        std::span<const std::size_t> lights) const {
    return lights;
  }
  const std::vector<double>& seenFractions(std::size_t light, const PatchSamples& samples);
  double seenFraction(std::size_t light, const SamplePoint& at) {
    if (this->light(light).isArea()) return areas().seenFraction(light, at, costs_[light]);
    if (const SunVisibility* sun = visibilities_.sun(light)) return seenFraction(*sun, light, at);
    return seenFraction(visibilities_.fine(light), light, at);
  }
  double roughlySeenFraction(std::size_t light, const SamplePoint& at) {
    if (this->light(light).isArea()) return areas().seenFraction(light, at, costs_[light]);
    if (visibilities_.sun(light)) return seenFraction(visibilities_.roughSun(light), light, at);
    return seenFraction(visibilities_.rough(light), light, at);
  }
  double unshadowedBrightness(std::size_t light, const SamplePoint& at) const;
  const std::vector<double>& brightness(std::size_t light, const PatchSamples& samples);

  /// One for each light of the level, in their order.
  const std::vector<LightCost>& costs() const { return costs_; }
  /// The sectors that light of areas comes through.
  SectorSet met() const { return areas_ ? areas_->met() : SectorSet(); }

 private:
  AreaLattice& areas();
  bool isInsideMesh(Vec3 point, SectorId sector, SectorSet& met) const;
  double seenFraction(const LightVisibility& visibility, std::size_t light, const SamplePoint& at);
  double seenFraction(const SunVisibility& sun, std::size_t light, const SamplePoint& at);
  FacePoint facePointAt(const SamplePoint& at) const {
    return {at.target, surface().normal, place_.mesh};
  }

  Scene scene_;
  const LightVisibilities& visibilities_;
  bool lambert_;
  const MeshPlace& place_;
  MeshShafts shafts_;
  std::optional<AreaLattice> areas_;  ///< once it is asked
  std::vector<std::size_t> facing_;
  std::vector<LightCost> costs_;
  std::vector<double> seen_;
  std::vector<double> brightness_;
};

}  // namespace hearth
