#pragma once

#include <cstddef>
#include <deque>
#include <span>

#include "light/baking/sample_rays.h"

namespace hearth {

/// Finds which fraction of a sun samples see: by shafts to blocks of them, and by rays where shafts
/// do not decide.
class SampleSuns {
 public:
  /// Keeps a reference to `rays`.
  explicit SampleSuns(SampleRays& rays) : rays_(rays) {}

  /// For all samples, into `seen` by their indices.
  void find(std::size_t light, const SampleBlocks& blocks, std::span<double> seen);

 private:
  SkyShaft& shaftAt(std::size_t depth);
  void find(std::size_t light, const SampleBlocks& blocks, const SampleBlocks::Block& block,
            std::size_t depth, std::span<double> seen);

  SampleRays& rays_;
  std::deque<SkyShaft> shafts_;  ///< from a block, from its part, from a part of that and so on
};

}  // namespace hearth
