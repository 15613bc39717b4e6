#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "level/level.h"
#include "math/box3.h"
#include "math/box_tree.h"
#include "math/tolerance.h"

namespace hearth {

/// Where lights are, and how far they reach: suns and the sky everywhere. Lights are indices.
class LightReach {
 public:
  LightReach(std::span<const LightSource> lights, const BakeSettings& settings);

  std::size_t lights() const { return metres_.size(); }
  /// Metres beyond which a light is left out, see LightSource::reach.
  double metres(std::size_t light) const { return metres_[light]; }
  /// Metres; 0 for a light that is baked as a point, or has no place.
  double radius(std::size_t light) const { return radii_[light]; }
  /// Whether points can see a part of it: a ball, a sun with a size, or the sky.
  bool isSoft(std::size_t light) const { return areSoft_[light]; }

  /// Whether the light reaches a point of a box, or misses it by no more than authors' files are
  /// inexact. A spot may reach none even then, but all that it lights is reached.
  bool reaches(std::size_t light, const Box3& box) const {
    if (metres_[light] == 0) return false;
    // As squares: this is asked of many lights for each tile.
    const double most = metres_[light] + kAuthorNoise;
    const Vec3 toBox = box.vectorFrom(positions_[light]);
    return dot(toBox, toBox) < most * most && (!spots_[light] || isInSpot(light, box));
  }
  /// Whether a light goes out towards a point: if it is a spot, the point is in its cone.
  bool isInSpot(std::size_t light, Vec3 point) const {
    return !spots_[light] || spots_[light]->factor(point - positions_[light]) > 0;
  }
  /// Whether that is certain of all points that are no farther than `slack` metres from a box.
  bool isAllInSpot(std::size_t light, std::span<const Vec3> corners, double slack) const;

  /// All lights that do, in their order.
  std::vector<std::size_t> reaching(const Box3& box) const;
  /// Those of some that do.
  std::vector<std::size_t> reaching(const Box3& box, std::span<const std::size_t> lights) const;

 private:
  bool isInSpot(std::size_t spot, const Box3& box) const;

  std::vector<double> metres_;
  std::vector<double> radii_;
  std::vector<bool> areSoft_;
  std::vector<Vec3> positions_;
  std::vector<std::optional<Spot>> spots_;
  BoxTree onMap_;
};

}  // namespace hearth
