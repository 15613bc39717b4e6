#pragma once

#include <span>
#include <vector>

#include "light/baking/light_dependencies.h"
#include "light/baking/sample_areas.h"
#include "light/baking/sample_beams.h"
#include "light/baking/sample_rays.h"
#include "light/baking/sample_shafts.h"
#include "light/baking/sample_suns.h"
#include "light/baking/surface_places.h"

namespace hearth {

/// How it is decided whether samples see a light.
enum class VisibilityMethod {
  Shafts,   ///< by beam trees or shafts, and by rays where those do not decide
  RaysOnly  ///< by rays for each sample; the other way is compared with it
};

/// Indices of the lights that can shine on a surface's plane and reach the surface.
std::vector<std::size_t> lightsFacing(const Scene& scene, const LightReach& reach,
                                      const LitSurface& surface);

/// The light that arrives at points of one surface.
class SurfaceLight : public SurfacePlaces {
 public:
  using Blocks = SampleBlocks;

  /// Keeps references to `surfaces`, `visibilities` and `dependencies`. `dependencies`, if any,
  /// records what the light depends on.
  SurfaceLight(const Scene& scene, const LitSurfaces& surfaces,
               const LightVisibilities& visibilities, bool lambert, SurfaceId id,
               VisibilityMethod method = VisibilityMethod::Shafts,
               LightDependencies* dependencies = nullptr);
  SurfaceLight(const SurfaceLight&) = delete;
  SurfaceLight& operator=(const SurfaceLight&) = delete;

  /// See lightsFacing().
  const std::vector<std::size_t>& facing() const { return facing_; }
  /// Those of them that reach some texels. Samples may lie outside their texels, and so see others.
  std::vector<std::size_t> facing(const TexelRect& texels) const;
  const LightSource& light(std::size_t index) const { return rays_.light(index); }
  /// Whether samples can see a part of a light.
  bool isSoft(std::size_t light) const { return rays_.visibilities().reach.isSoft(light); }
  /// 3 where one of the facing lights is coloured, else 1.
  int channels() const;

  /// Those of the lights that may reach some of the samples.
  std::vector<std::size_t> reaching(const SampleBlocks& blocks,
                                    std::span<const std::size_t> lights) const;

  SampleBlocks inBlocks(std::vector<SamplePoint> samples, int columns) const;

  /// The fraction of a light that each of the samples sees, in their order; for spare ones nothing
  /// that counts. Valid until the next call.
  const std::vector<double>& seenFractions(std::size_t light, const SampleBlocks& blocks);

  /// The fraction of a light that the point sees, 0..1.
  double seenFraction(std::size_t light, const SamplePoint& at);
  /// The same, with fewer rays to a ball.
  double roughlySeenFraction(std::size_t light, const SamplePoint& at);

  /// The light at the point if it sees all of the source: in levels, before colour.
  double unshadowedBrightness(std::size_t light, const SamplePoint& at) const;
  /// The light at each of the samples, in levels, before colour. Call seenFractions() with the same
  /// arguments first. Valid until the next call.
  const std::vector<double>& brightness(std::size_t light, const SampleBlocks& blocks);

  /// One for each light of the level, in their order.
  const std::vector<LightCost>& costs() const { return rays_.costs(); }

 private:
  void findSeen(std::size_t light, const SampleBlocks& blocks);
  void findLevels(std::size_t light, const SampleBlocks& blocks);

  bool lambert_;
  VisibilityMethod method_;
  SampleRays rays_;
  SampleShafts shafts_;
  SampleBeams beams_;
  SampleSuns suns_;
  SampleAreas areas_;
  std::vector<std::size_t> facing_;
  std::vector<double> seen_;
  std::vector<double> distances_;  ///< from a light to samples, metres
  std::vector<double> brightness_;
};

}  // namespace hearth
