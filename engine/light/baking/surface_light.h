#pragma once

#include <span>
#include <vector>

#include "light/baking/sample_beams.h"
#include "light/baking/sample_rays.h"
#include "light/baking/sample_shafts.h"
#include "light/rebaking/light_dependencies.h"

namespace hearth {

/// How samples are asked whether they see a light.
enum class Seeing {
  ByShafts,    ///< by beam trees or shafts, and by rays where these do not decide
  ByRaysAlone  ///< each by itself: what the others are compared with
};

/// The light that arrives at points of one surface.
class SurfaceLight {
 public:
  /// Keeps references to all but `scene` and `id`. `dependencies`, if any, records what the
  /// light depends on.
  SurfaceLight(const Scene& scene, const LitSurfaces& surfaces, const LightSights& sights,
               bool lambert, SurfaceId id, Seeing seeing = Seeing::ByShafts,
               LightDependencies* dependencies = nullptr);
  SurfaceLight(const SurfaceLight&) = delete;
  SurfaceLight& operator=(const SurfaceLight&) = delete;

  const TexelRect& texels() const { return surface_.texels; }
  AskedRow askedIn(int j) const { return {surface_, j}; }
  /// Indices of the lights that can shine on the surface's plane, and reach as far.
  const std::vector<std::size_t>& facing() const { return facing_; }
  const LightSource& light(std::size_t index) const { return rays_.light(index); }
  /// Metres; 0 for a point light.
  double radiusOf(std::size_t light) const { return rays_.radiusOf(light); }
  /// 3 where one of the facing lights is coloured, else 1.
  int channels() const;

  /// Whether a light reaches as far as some of the samples, perhaps.
  bool reaches(std::size_t light, const SampleBlocks& blocks) const;

  SamplePoint place(Vec2 texelPoint) const;
  /// Adds those of a row of points, at rising `columns` on the height `row`.
  void placeRow(std::span<const double> columns, double row,
                std::vector<SamplePoint>& places) const;
  SampleBlocks inBlocks(std::vector<SamplePoint> samples, int columns, int rows) const;

  /// Which fraction of a light each of the samples sees, in their order. Good until the next call.
  const std::vector<double>& seenFractions(std::size_t light, const SampleBlocks& blocks);

  /// Which fraction of a light the point sees, 0..1.
  double seenFraction(std::size_t light, const SamplePoint& at);
  /// With fewer rays to a ball.
  double roughlySeenFraction(std::size_t light, const SamplePoint& at);

  /// What all of the light would bring to the point, in levels, before colour.
  double fullBrightness(std::size_t light, const SamplePoint& at) const;
  /// What it brings to each of the samples of which seenFractions() was asked last. Good until the
  /// next call.
  const std::vector<double>& levels(std::size_t light, const SampleBlocks& blocks);

  /// In the order of the level's lights.
  const std::vector<LightCost>& costs() const { return rays_.costs(); }

 private:
  bool reachesBox(std::size_t light, std::span<const Vec3> corners) const;

  const LitSurface& surface_;
  bool lambert_;
  Seeing seeing_;
  SamplePlacement placement_;
  SampleRays rays_;
  SampleShafts shafts_;
  SampleBeams beams_;
  std::vector<std::size_t> facing_;
  std::vector<double> seen_;
  std::vector<double> distances_;  ///< from a light to samples, metres
  std::vector<double> levels_;
};

}  // namespace hearth
