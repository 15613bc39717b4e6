#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "agreement/plain_texels.h"
#include "truth/truth_light.h"

namespace hearth::agreement {

/// Red, green and blue.
using Channels = std::array<double, 3>;

/// Truth's light of a texel.
struct TexelLight {
  std::vector<TexelSample> samples;
  std::vector<std::vector<bool>> sees;  ///< of each sample: by index of light, whether it sees it
  Channels levels{};                    ///< mean of the samples, not clamped
  bool lacksSamples = false;            ///< some are left out
  Texel texel{};
};

/// Truth's light of the four texels around a point.
struct PatchLight {
  std::array<const TexelLight*, 4> texels;
  std::array<double, 4> weights;  ///< what each counts for at the point

  /// Levels at the point, 0..255.
  double interpolated(std::size_t channel) const;
  /// Whether some of them clip at full light and some do not.
  bool clipsBetween(std::size_t channel) const;
  /// Whether some of them take the light of others, or of fewer samples.
  bool lacksSamples() const;
};

/// What texels hold by truth, and how well each of them is known.
class TexelTruth {
 public:
  /// Keeps the scene, whose level's lights must be points and whose bake must say how many samples
  /// a texel has.
  explicit TexelTruth(const Scene& scene);

  /// None where the hit is on no surface that takes light. Of use for as long as this.
  std::optional<PatchLight> around(const SurfacePoint& hit);

  /// Levels at the very point, not clamped.
  Channels at(const SurfacePoint& place) const;
  Channels at(const AirPoint& place) const;

  /// Levels by which the texels' light at the point may be another because the places of their
  /// samples are known to a hair only: at the edges of shadows and at jumps of curves.
  Channels hairSlack(const PatchLight& patch);
  /// The same of a point of air.
  Channels hairSlack(const AirPoint& place) const;

  /// Whether a jump of a curve is so near to a sample.
  bool isAtJump(const PatchLight& patch) const;

  /// Whether each light is seen by all samples if it is by `hit`, and by none if not.
  bool seesAlike(const PatchLight& patch, const SurfacePoint& hit) const;

  /// Levels by which light interpolated between the texels can miss that at `hit` because of jumps,
  /// bends and steepness of the lights' curves and spots. `hit` must see what they see.
  Channels missAtCurves(const PatchLight& patch, const SurfacePoint& hit) const;

  /// Levels by which the texels' light is another than where their samples' centres are, at the
  /// point: samples from beyond an edge take the light of the nearest point of the surface.
  Channels missBeyondEdge(const PatchLight& patch) const;

 private:
  const TexelLight& lightOf(const Texel& texel);
  Channels stepAround(const TexelSample& sample);
  Channels fourthOf(const Texel& texel);
  void add(Channels& sum, std::size_t light, double level) const;

  Scene scene_;
  const Level& level_;
  TruthLight truth_;
  PlainTexels texels_;
  std::map<Texel, TexelLight> lights_;  ///< those that were asked for
};

}  // namespace hearth::agreement
