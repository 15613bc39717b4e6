#pragma once

#include <span>
#include <vector>

#include "level/scene.h"
#include "light/gather/area_lights.h"
#include "math/box3.h"

namespace hearth {

class Hash;

/// Compass directions, in degrees: 0 along +x, 90 along +y.
struct CompassInterval {
  double from;   ///< 0..360
  double width;  ///< beyond `from`
};

/// Where a level's surfaces are that shine: so that a point can look closely at those that are
/// small as seen from it.
class SmallAreas {
 public:
  SmallAreas(const Scene& scene, const AreaLights& lights);

  /// Adds to `found` the directions in which surfaces lie that fill less than `widest` degrees of
  /// the compass around a point, if they may give it more than these fractions of their light,
  /// which are by the places of lights.
  void findAround(Vec3 point, double widest, std::span<const double> least,
                  std::vector<CompassInterval>& found) const;

  /// Adds all that `findAround` depends on.
  void addTo(Hash& hash) const;

 private:
  struct Shining {
    AreaLights::Place light;
    Box3 box;
    double area;  ///< square metres, at most
  };

  void addSurface(const Scene& scene, SurfaceId id, AreaLights::Place light);
  void addFaces(const Level& level, const AreaLights& lights, const Mesh& mesh);

  std::vector<Shining> shining_;
};

}  // namespace hearth
