#pragma once

#include <span>
#include <vector>

#include "light/beam_tree/beam.h"

namespace hearth {

/// Metres, in lengths of a way on the map from the light, to the line of a wall.
double distanceToLine(Vec3 light, const Segment& wall, Vec2 direction);
/// Metres on the map from the light to what a beam sees of a wall, or of its line.
double distanceToWall(Vec3 light, const Beam& beam, const Segment& wall);

/// What bounds beams below and above, while they are found.
class BeamPlanes {
 public:
  explicit BeamPlanes(Vec3 light) : light_(light) {}

  /// A straight line along a wall.
  struct Edge {
    double z0;  ///< at the wall's p0
    double z1;
    bool isBelow;  ///< rays go above it
  };

  /// Anew.
  void begin(std::span<const HeightPlane> planes) { planes_.assign(planes.begin(), planes.end()); }
  /// Of rays of the beam; planes that bound less of it than others are left out.
  void add(const Beam& beam, const Segment& wall, const Edge& edge);

  /// Whether nothing of the beam lies between what bounds it below and above.
  bool leaveNothingOf(const Beam& beam) const;
  std::span<const HeightPlane> all() const { return planes_; }

 private:
  Vec3 light_;
  std::vector<HeightPlane> planes_;
};

}  // namespace hearth
