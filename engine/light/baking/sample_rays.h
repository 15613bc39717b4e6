#pragma once

#include <cstdint>
#include <vector>

#include "level/scene.h"
#include "light/baking/light_dependencies.h"
#include "light/baking/light_visibility.h"
#include "light/light_cost.h"
#include "light/lit_surface.h"
#include "light/rays/shaft.h"
#include "light/sampling/sample_blocks.h"
#include "light/sampling/sample_placement.h"

namespace hearth {

/// Calls `visit(index)` for the samples of a block.
template <typename Visit>
void forEachSample(const SampleBlocks& blocks, const SampleBlocks::Block& block, Visit&& visit) {
  for (const std::uint32_t index : blocks.indices(block)) visit(index);
}

/// What a shaft says of a sample's rays.
struct KnownRays {
  const Shaft& shaft;
  TargetVisibility outcome;
};

/// The same of rays towards a sun.
struct KnownSkyRays {
  const SkyShaft& shaft;
  TargetVisibility outcome;
};

/// Traces rays to find which fraction of a light a sample sees. All samples are of one surface.
class SampleRays {
 public:
  /// Keeps references to `surfaces` and `visibilities`. `dependencies`, if any, records what the
  /// light depends on.
  SampleRays(const Scene& scene, const LitSurfaces& surfaces, const LightVisibilities& visibilities,
             SurfaceId id, LightDependencies* dependencies)
      : scene_(scene),
        surfaces_(surfaces),
        visibilities_(visibilities),
        id_(id),
        dependencies_(dependencies),
        costs_(scene.lights().size()) {}

  const Scene& scene() const { return scene_; }
  SurfaceId id() const { return id_; }
  const LitSurface& surface(SurfaceId id) const { return *surfaces_[id.index()]; }
  const LightSource& light(std::size_t index) const { return scene_.lights()[index]; }
  const LightVisibilities& visibilities() const { return visibilities_; }
  const LightVisibility& visibility(std::size_t light) const { return visibilities_.fine(light); }
  /// The same, with fewer rays to a ball.
  const LightVisibility& roughVisibility(std::size_t light) const {
    return visibilities_.rough(light);
  }
  double reach(std::size_t light) const { return visibilities_.reach.metres(light); }
  /// Null for a light with a place.
  const SunVisibility* sun(std::size_t light) const { return visibilities_.sun(light); }
  /// The set that records which sectors rays of the light enter; null if nothing records them.
  SectorSet* enteredSectors(std::size_t light) {
    return dependencies_ ? &dependencies_->sectorsOf(light) : nullptr;
  }

  /// Whether any part of a light can shine on the plane of a surface. A continuation may lie off
  /// this surface's plane, by a tolerance.
  bool canShineOn(std::size_t light, SurfaceId surface) const;

  /// Which fraction of a light the point sees, 0..1.
  double seenFraction(const LightVisibility& visibility, std::size_t light, const SamplePoint& at,
                      const KnownRays* known);
  double seenFraction(const SunVisibility& sun, std::size_t light, const SamplePoint& at,
                      const KnownSkyRays* known);
  /// The same if nothing hides the light from the point: 1, or 0 if the light is too far away.
  double unoccludedFraction(std::size_t light, const SamplePoint& at);

  /// Whether the light reaches all samples whose rays arrive in a box.
  bool isAllInReach(std::size_t light, const TargetBox& targets) const;

  void countSamples(std::size_t light, std::int64_t samples) { costs_[light].samples += samples; }
  void countSeenSamples(std::size_t light, std::int64_t samples) {
    costs_[light].seenSamples += samples;
  }
  LightCost& cost(std::size_t light) { return costs_[light]; }
  /// In the order of the level's lights.
  const std::vector<LightCost>& costs() const { return costs_; }

 private:
  template <typename Visibility, typename Known>
  double seenFractionBy(const Visibility& visibility, std::size_t light, const SamplePoint& at,
                        const Known* known);
  bool isInReach(std::size_t light, const SamplePoint& at) const;

  Scene scene_;
  const LitSurfaces& surfaces_;
  const LightVisibilities& visibilities_;
  SurfaceId id_;
  LightDependencies* dependencies_;
  std::vector<LightCost> costs_;
};

/// Whether any part of a light can shine on the plane of the surface. No part of a ball
/// can if its centre lies in the plane.
bool isInFront(const Scene& scene, const LightReach& reach, std::size_t light,
               const LitSurface& surface);

}  // namespace hearth
