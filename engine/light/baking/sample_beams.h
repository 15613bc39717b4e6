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
  /// What the beams say of points on one surface.
  struct BeamAnswer {
    SurfaceId surface;
    bool isInFront;  ///< whether the light can shine on it; a continuation may be tilted away
    TargetVisibility outcome;
    bool isAnswered;  ///< whether the beams give an answer
    /// If the outcome is unknown, these beams can contain some of the points: a range of
    /// `candidates_`.
    std::size_t first;
    std::size_t last;
  };
  /// The entries of a block in `answers_`: one for each surface that can hold its samples.
  struct Range {
    std::size_t first;
    std::size_t last;
  };

  const BeamTree& treeOf(std::size_t light) const { return *rays_.visibility(light).beams(); }
  const Segment* wallOf(SurfaceId surface) const;
  BeamAnswer answerFor(SurfaceId surface, bool areLit, std::size_t first) const;
  BeamAnswer ask(std::size_t light, SurfaceId surface, std::span<const Vec3> corners);
  BeamAnswer refine(std::size_t light, const BeamAnswer& before, std::span<const Vec3> corners);
  std::span<const BeamAnswer> in(Range range) const {
    return std::span(answers_).subspan(range.first, range.last - range.first);
  }
  void findWithin(const Query& query, const SampleBlocks::Block& block, Range around);
  void findBlock(const Query& query, const SampleBlocks::Block& block, Range here);
  bool mayMeetMesh(const Query& query, const SampleBlocks::Block& block);
  void findAlike(const Query& query, const SampleBlocks::Block& block, bool areLit);
  void findOneByOne(const Query& query, const SampleBlocks::Block& block,
                    std::span<const BeamAnswer> here);
  void findOn(const BeamAnswer& here, const Query& query, const SampleBlocks::Block& block);
  double seenFraction(std::size_t light, const SamplePoint& at, const BeamAnswer& around);

  SampleRays& rays_;
  SampleShafts& shafts_;
  BeamTree::Candidates candidates_;
  BeamTree::Scratch scratch_;
  std::vector<BeamAnswer> answers_;
  /// That rays of the query may meet; none until a block asks.
  std::optional<std::vector<std::uint32_t>> meshes_;
  std::vector<double> seenIfOn_;  ///< `seen`, as if all samples lay on one surface
};

}  // namespace hearth
