#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "light/baking/sample_rays.h"
#include "light/baking/sample_shafts.h"
#include "light/beam_tree/beam_tree.h"

namespace hearth {

/// Finds which fraction of a point light each sample sees. It asks the light's beams, and takes
/// shafts and rays where the beams give no answer.
class SampleBeams {
 public:
  /// Keeps references to both.
  SampleBeams(SampleRays& rays, SampleShafts& shafts) : rays_(rays), shafts_(shafts) {}

  /// Writes the fractions of all samples to `seen`, by their indices. `seen` is 0 before. The light
  /// must have beams.
  void find(std::size_t light, const SampleBlocks& blocks, std::span<double> seen);

 private:
  /// The arguments of `find`.
  struct Task {
    std::size_t light;
    const SampleBlocks& blocks;
    std::span<double> seen;
  };
  /// What the beams say of points on one surface.
  struct OnSurface {
    SurfaceId surface;
    bool isInFront;  ///< whether the light can shine on it; a continuation may be tilted away
    Shaft::Outcome outcome;
    bool isKnown;  ///< whether the beams give an answer
    /// If the outcome is unknown, these beams can contain some of the points: a range of `beams_`.
    std::size_t first;
    std::size_t last;
  };
  /// The entries of a block in `onSurfaces_`: one for each surface that can hold its samples.
  struct Range {
    std::size_t first;
    std::size_t last;
  };

  const BeamTree& treeOf(std::size_t light) const { return *rays_.sight(light).beams(); }
  const Segment* wallOf(SurfaceId surface) const;
  OnSurface lyingIn(SurfaceId surface, bool areLit, std::size_t first) const;
  OnSurface found(std::size_t light, SurfaceId surface, std::span<const Vec3> corners);
  OnSurface narrowed(std::size_t light, const OnSurface& before, std::span<const Vec3> corners);
  std::span<const OnSurface> in(Range range) const {
    return std::span(onSurfaces_).subspan(range.first, range.last - range.first);
  }
  void findWithin(const Task& task, const SampleBlocks::Block& block, Range around);
  void findBlock(const Task& task, const SampleBlocks::Block& block, Range here);
  void findAlike(const Task& task, const SampleBlocks::Block& block, bool areLit);
  void findOneByOne(const Task& task, const SampleBlocks::Block& block,
                    std::span<const OnSurface> here);
  void findOn(const OnSurface& here, const Task& task, const SampleBlocks::Block& block);
  double seenFraction(std::size_t light, const SamplePoint& at, const OnSurface& around);

  SampleRays& rays_;
  SampleShafts& shafts_;
  BeamTree::Found beams_;
  BeamTree::Parting parting_;
  std::vector<OnSurface> onSurfaces_;
  std::vector<double> seenIfOn_;  ///< `seen`, as if all samples lay on one surface
};

}  // namespace hearth
