#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/light_cost.h"
#include "light/lit_surface.h"
#include "light/rebaking/light_dependencies.h"
#include "light/sampling/sample_blocks.h"
#include "light/sampling/sample_placement.h"
#include "light/sight/light_sight.h"

namespace hearth {

/// How samples are asked whether they see a light.
enum class Seeing {
  ByShafts,    ///< by beam trees or shafts, and by rays where these do not decide
  ByRaysAlone  ///< each by itself: what the others are compared with
};

/// What of the level's lights arrives at points of one surface.
class SurfaceLight {
 public:
  /// Keeps references to all but `scene` and `id`. `dependencies`, if any, is told from what light
  /// is found.
  SurfaceLight(const Scene& scene, const LitSurfaces& surfaces, const LightSights& sights,
               bool lambert, SurfaceId id, Seeing seeing = Seeing::ByShafts,
               LightDependencies* dependencies = nullptr);

  const TexelRect& texels() const { return surface_.texels; }
  AskedRow askedIn(int j) const { return {surface_, j}; }
  /// Indices of the lights that can shine on the surface's plane, and reach as far.
  const std::vector<std::size_t>& facing() const { return facing_; }
  const LightSource& light(std::size_t index) const { return scene_.level().lights[index]; }
  /// Of the ball as which it is seen; 0 of a point.
  double radiusOf(std::size_t light) const;
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
  double fullLevel(std::size_t light, const SamplePoint& at) const;
  /// What it brings to each of the samples of which seenFractions() was asked last. Good until the
  /// next call.
  const std::vector<double>& levels(std::size_t light, const SampleBlocks& blocks);

  /// In the order of the level's lights.
  const std::vector<LightCost>& costs() const { return costs_; }

 private:
  /// What is known of a sample's rays.
  struct Known {
    const Shaft& shaft;
    Shaft::Outcome outcome;
  };
  /// Told of sectors that rays of the light come into; if any.
  SectorSet* metBy(std::size_t light) {
    return dependencies_ ? &dependencies_->sectorsOf(light) : nullptr;
  }
  bool canShineOn(std::size_t light, SurfaceId surface) const;
  bool isInReach(std::size_t light, const SamplePoint& at) const;
  Vec3 normalOf(SurfaceId surface) const;
  bool reachesBox(std::size_t light, std::span<const Vec3> corners) const;
  double seenFraction(const LightSight& sight, std::size_t light, const SamplePoint& at,
                      const Known* known);
  /// What beams say of points on a surface.
  struct ByBeams {
    SurfaceId surface;
    bool isInFront;  ///< whether the light can shine on it: what continues a surface may be turned
    Shaft::Outcome outcome;
    bool isKnown;  ///< whether they say anything
    /// Where the outcome is unknown: those of `beams_` that some of the points can lie in.
    std::size_t first;
    std::size_t last;
  };
  /// Some of `byBeams_`: of a block, for each of the surfaces that it can have samples on.
  struct Range {
    std::size_t first;
    std::size_t last;
  };
  const Segment* wallOf(SurfaceId surface) const;
  ByBeams byBeams(SurfaceId surface, bool areLit, std::size_t first) const;
  ByBeams findBeams(std::size_t light, SurfaceId surface, std::span<const Vec3> corners);
  ByBeams narrowed(std::size_t light, const ByBeams& before, std::span<const Vec3> corners);
  std::span<const ByBeams> in(Range range) const {
    return std::span(byBeams_).subspan(range.first, range.last - range.first);
  }
  void addPointLight(std::size_t light, const SampleBlocks& blocks);
  void addByBeams(std::size_t light, const SampleBlocks& blocks, const SampleBlocks::Block& block,
                  Range around);
  void addAllByBeams(std::size_t light, const SampleBlocks& blocks,
                     const SampleBlocks::Block& block, Range here);
  void addAlike(std::size_t light, const SampleBlocks& blocks, const SampleBlocks::Block& block,
                bool areLit);
  void addOneByOne(std::size_t light, const SampleBlocks& blocks, const SampleBlocks::Block& block,
                   std::span<const ByBeams> here);
  void findSeenOf(const ByBeams& here, std::size_t light, const SampleBlocks& blocks,
                  const SampleBlocks::Block& block);
  double seenFractionByBeams(std::size_t light, const SamplePoint& at, const ByBeams& around);
  void see(std::size_t light, const SamplePoint& at, double& seen);
  Shaft& shaftAt(std::size_t depth);
  Shaft::Outcome followShaft(std::size_t depth, std::size_t light, const ShaftLight& from,
                             const ShaftTargets& targets);
  void addBlock(std::size_t light, const SampleBlocks& blocks, const SampleBlocks::Block& block,
                std::size_t depth);
  void addSamples(std::size_t light, const SampleBlocks& blocks, const SampleBlocks::Block& block,
                  const Known& known);
  double seenFractionByShaft(const LightSight& sight, std::size_t light, const SamplePoint& at,
                             std::size_t depth);

  Scene scene_;
  const LitSurfaces& surfaces_;
  const LightSights& sights_;
  const LitSurface& surface_;
  SurfaceId id_;
  bool lambert_;
  Seeing seeing_;
  LightDependencies* dependencies_;
  SamplePlacement placement_;
  std::vector<std::size_t> facing_;
  std::vector<LightCost> costs_;
  std::deque<Shaft> shafts_;  ///< to a block, to its part, to a part of this and so on
  BeamTree::Found beams_;
  BeamTree::Parting parting_;
  std::vector<ByBeams> byBeams_;
  std::vector<double> seen_;
  std::vector<double> seenIfOn_;   ///< the same if all samples lay on one surface
  std::vector<double> distances_;  ///< from a light to samples, metres
  std::vector<double> levels_;
};

}  // namespace hearth
