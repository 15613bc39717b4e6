#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "light/baking/sample_rays.h"

namespace hearth {

/// Finds which fraction of a light samples see: by shafts to blocks of them, and by rays where
/// shafts do not decide.
class SampleShafts {
 public:
  /// Keeps a reference to `rays`.
  explicit SampleShafts(SampleRays& rays) : rays_(rays) {}

  /// For the samples of a block, into `seen` by their indices.
  void find(std::size_t light, const SampleBlocks& blocks, const SampleBlocks::Block& block,
            std::span<double> seen) {
    find(light, blocks, block, 0, seen);
  }

  /// For one sample. This pays off for a ball, which takes many rays.
  double seenFraction(const LightVisibility& visibility, std::size_t light, const SamplePoint& at) {
    return seenFraction(visibility, light, at, 0);
  }

  /// Records the sectors that rays of a light to a block can enter.
  void noteSectors(std::size_t light, const ShaftTargets& targets) {
    follow(0, light, rays_.visibility(light).shaftLight(), targets);
  }

  /// The meshes that may stop rays of a light to targets, by index. Looks at all meshes, in
  /// whatever sectors.
  std::vector<std::uint32_t> meshesToMeet(std::size_t light, const ShaftTargets& targets) const;
  /// Whether one of these may, for targets among those.
  bool mayMeetMesh(std::size_t light, const ShaftTargets& targets,
                   std::span<const std::uint32_t> meshes) const;

  /// A shaft for rays whose outcome is already known.
  const Shaft& any() { return shaftAt(0); }

 private:
  Shaft& shaftAt(std::size_t depth);
  TargetVisibility follow(std::size_t depth, std::size_t light, const ShaftLight& from,
                          const ShaftTargets& targets);
  void find(std::size_t light, const SampleBlocks& blocks, const SampleBlocks::Block& block,
            std::size_t depth, std::span<double> seen);
  void findEach(std::size_t light, const SampleBlocks& blocks, const SampleBlocks::Block& block,
                const KnownRays& known, std::span<double> seen);
  double seenFraction(const LightVisibility& visibility, std::size_t light, const SamplePoint& at,
                      std::size_t depth);

  SampleRays& rays_;
  std::deque<Shaft> shafts_;  ///< to a block, to its part, to a part of that and so on
};

}  // namespace hearth
