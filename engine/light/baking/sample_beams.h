#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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
  struct Query {
    std::size_t light;
    const SampleBlocks& blocks;
    std::span<double> seen;
  };
  /// If the outcome is unknown, these beams can contain some of the points: a range of
  /// `candidates_`.
  struct BeamAnswer {
    TargetVisibility outcome;
    std::size_t first;
    std::size_t last;
  };

  const BeamTree& treeOf(std::size_t light) const { return *rays_.visibility(light).beams(); }
  const Segment* wallOf(SurfaceId surface) const;
  BeamAnswer answerFor(bool areLit, std::size_t first) const;
  void findOnSurface(const Query& query, const SampleBlocks::Block& block);
  BeamAnswer refine(std::size_t light, SurfaceId surface, const BeamAnswer& around,
                    std::span<const Vec3> corners);
  void findBlock(const Query& query, const SampleBlocks::Block& block, const BeamAnswer& here);
  bool mayMeetMesh(const Query& query, const SampleBlocks::Block& block);
  void findLit(const Query& query, const SampleBlocks::Block& block);
  void findOneByOne(const Query& query, const SampleBlocks::Block& block, const BeamAnswer& here);
  double seenFraction(std::size_t light, const SamplePoint& at, const BeamAnswer& around);

  SampleRays& rays_;
  SampleShafts& shafts_;
  BeamTree::Candidates candidates_;
  BeamTree::Scratch scratch_;
  /// That rays of the query may meet; none until a block asks.
  std::optional<std::vector<std::uint32_t>> meshes_;
  std::vector<double> seenHere_;  ///< by the samples of a block
};

}  // namespace hearth
