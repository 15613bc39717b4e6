#pragma once

#include <vector>

#include "truth/trace.h"

namespace hearth {

/// The light at points of surfaces as the file format defines it, not as any bake samples it: the
/// reference for bakes. Points of light only: the radius of lights is ignored.
class TruthLight {
 public:
  /// Keeps a reference to the level.
  explicit TruthLight(const Level& level);

  /// Levels (255 is full) of red, green and blue, neither clamped nor rounded: the sum over the
  /// lights that see the point.
  Vec3 at(const SurfacePoint& place) const;

  /// What the light of that index would add to each if it were white; 0 where it does not see the
  /// point.
  double from(std::size_t light, const SurfacePoint& place) const;

 private:
  const Level& level_;
  std::vector<Vec3> origins_;  ///< of the lights' rays, by index of light
};

}  // namespace hearth
