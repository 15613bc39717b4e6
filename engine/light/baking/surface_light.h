#pragma once

#include <span>
#include <vector>

#include "light/baking/light_dependencies.h"
#include "light/baking/sample_beams.h"
#include "light/baking/sample_rays.h"
#include "light/baking/sample_shafts.h"

namespace hearth {

/// How it is decided whether samples see a light.
enum class VisibilityMethod {
  Shafts,   ///< by beam trees or shafts, and by rays where those do not decide
  RaysOnly  ///< by rays for each sample; the other way is compared with it
};

/// Whether samples of a surface, or of what continues it, may lie inside meshes.
bool mayHaveSamplesInMeshes(const Scene& scene, const LitSurfaces& surfaces, SurfaceId id);

/// The light that arrives at points of one surface.
class SurfaceLight {
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

  const TexelRect& texels() const { return surface_.texels; }
  UsedTexelRow usedRuns(int j) const { return {surface_, j}; }
  /// Indices of the lights that can shine on the surface's plane and reach it.
  const std::vector<std::size_t>& facing() const { return facing_; }
  const LightSource& light(std::size_t index) const { return rays_.light(index); }
  /// Metres; 0 for a point light.
  double radiusOf(std::size_t light) const { return rays_.radiusOf(light); }
  /// 3 where one of the facing lights is coloured, else 1.
  int channels() const;

  /// Whether a light may reach some of the samples.
  bool reaches(std::size_t light, const SampleBlocks& blocks) const;

  SamplePoint place(Vec2 texelPoint) const;
  /// Adds to `places` the samples of a row of points, in texel coordinates; `columns` rise.
  void placeRow(std::span<const double> columns, double row,
                std::vector<SamplePoint>& places) const;
  SampleBlocks inBlocks(std::vector<SamplePoint> samples, int columns, int rows) const;

  /// Whether a sample lies inside a mesh, and so is left out of its texel.
  bool isLeftOut(const SamplePoint& at) const;
  /// False if none can be.
  bool mayLeaveOut() const { return mayLeaveOut_; }

  /// The fraction of a light that each of the samples sees, in their order. Valid until the next
  /// call.
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
  bool reachesBox(std::size_t light, std::span<const Vec3> corners) const;

  const LitSurface& surface_;
  bool lambert_;
  VisibilityMethod method_;
  SamplePlacement placement_;
  SampleRays rays_;
  SampleShafts shafts_;
  SampleBeams beams_;
  bool mayLeaveOut_;
  std::vector<std::size_t> facing_;
  std::vector<double> seen_;
  std::vector<double> distances_;  ///< from a light to samples, metres
  std::vector<double> brightness_;
};

}  // namespace hearth
