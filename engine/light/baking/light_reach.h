#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "level/level.h"
#include "math/box3.h"
#include "math/box_tree.h"
#include "math/tolerance.h"

namespace hearth {

/// Where the lights of a level are, and how far they reach. Lights are indices.
class LightReach {
 public:
  LightReach(const Level& level, const BakeSettings& settings);

  std::size_t lights() const { return metres_.size(); }
  /// Metres beyond which a light is left out, see LightSource::reach.
  double metres(std::size_t light) const { return metres_[light]; }
  /// Metres; 0 for a light that is baked as a point.
  double radius(std::size_t light) const { return radii_[light]; }

  /// Whether the light reaches a point of a box, or misses it by no more than authors' files are
  /// inexact.
  bool reaches(std::size_t light, const Box3& box) const {
    // As squares: this is asked of many lights for each tile.
    const double most = metres_[light] + kAuthorNoise;
    const Vec3 toBox = box.vectorFrom(positions_[light]);
    return dot(toBox, toBox) < most * most;
  }
  /// All lights that do, in their order.
  std::vector<std::size_t> reaching(const Box3& box) const;
  /// Those of some that do.
  std::vector<std::size_t> reaching(const Box3& box, std::span<const std::size_t> lights) const;

 private:
  std::vector<double> metres_;
  std::vector<double> radii_;
  std::vector<Vec3> positions_;
  BoxTree onMap_;
};

}  // namespace hearth
