#pragma once

#include <span>
#include <vector>

#include "light/beam_tree/beam.h"

namespace hearth {

/// The t at which light + t * direction lies on the line of a wall, in plan.
double distanceToLine(Vec3 light, const Segment& wall, Vec2 direction);
/// Metres in plan from the light to the part of a wall, or of its line, that a beam sees.
double distanceToWall(Vec3 light, const Beam& beam, const Segment& wall);

/// The planes that bound beams below and above, while the beams are found.
class BeamPlanes {
 public:
  explicit BeamPlanes(Vec3 light) : light_(light) {}

  /// A straight line along a wall.
  struct Edge {
    double z0;  ///< at the wall's p0
    double z1;
    bool isBelow;  ///< rays go above it
  };

  /// Clears the planes and copies `planes`.
  void begin(std::span<const HeightPlane> planes) { planes_.assign(planes.begin(), planes.end()); }
  /// Adds the plane through the light and an edge, unless others bound the beam more closely.
  void add(const Beam& beam, const Segment& wall, const Edge& edge);

  /// Whether nothing of the beam is left between the planes below and above.
  bool leaveNothingOf(const Beam& beam) const;
  std::span<const HeightPlane> all() const { return planes_; }

 private:
  Vec3 light_;
  std::vector<HeightPlane> planes_;
};

}  // namespace hearth
