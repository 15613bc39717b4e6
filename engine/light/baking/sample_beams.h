#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "light/baking/sample_rays.h"
#include "light/baking/sample_shafts.h"
#include "light/beam_tree/beam_tree.h"

namespace hearth {

/// Which fraction of a point light samples see, by the light's beams, and by shafts and rays where
/// these say nothing.
class SampleBeams {
 public:
  /// Keeps references to both.
  SampleBeams(SampleRays& rays, SampleShafts& shafts) : rays_(rays), shafts_(shafts) {}

  /// Of all samples, into `seen` by their indices, where it is 0. The light has beams.
  void find(std::size_t light, const SampleBlocks& blocks, std::span<double> seen);

 private:
  /// What is to be found, and where it goes.
  struct Task {
    std::size_t light;
    const SampleBlocks& blocks;
    std::span<double> seen;
  };
  /// What beams say of points on a surface.
  struct OnSurface {
    SurfaceId surface;
    bool isInFront;  ///< whether the light can shine on it: what continues a surface may be turned
    Shaft::Outcome outcome;
    bool isKnown;  ///< whether they say anything
    /// Where the outcome is unknown: those of `beams_` that some of the points can lie in.
    std::size_t first;
    std::size_t last;
  };
  /// Some of `onSurfaces_`: of a block, for each of the surfaces that it can have samples on.
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
  std::vector<double> seenIfOn_;  ///< the same if all samples lay on one surface
};

}  // namespace hearth
