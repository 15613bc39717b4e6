#pragma once

#include <span>
#include <vector>

#include "light/light_cone.h"

namespace hearth {

/// Metres, in lengths of a way on the map from the light, to the line of a wall.
double distanceToLine(Vec3 light, const Segment& wall, Vec2 way);
/// Metres on the map from the light to what a cone sees of a wall, or of its line.
double distanceToWall(Vec3 light, const LightCone& cone, const Segment& wall);

/// What bounds cones below and above, while they are found.
class ConePlanes {
 public:
  explicit ConePlanes(Vec3 light) : light_(light) {}

  /// A straight line along a wall.
  struct Edge {
    double z0;  ///< at the wall's p0
    double z1;
    bool isBelow;  ///< rays go above it
  };

  /// Anew.
  void begin(std::span<const HeightPlane> planes) { planes_.assign(planes.begin(), planes.end()); }
  /// Of rays of the cone; planes that bound less of it than others are left out.
  void add(const LightCone& cone, const Segment& wall, const Edge& edge);

  /// Whether nothing of the cone lies between what bounds it below and above.
  bool leaveNothingOf(const LightCone& cone) const;
  std::span<const HeightPlane> all() const { return planes_; }

 private:
  Vec3 light_;
  std::vector<HeightPlane> planes_;
};

}  // namespace hearth
