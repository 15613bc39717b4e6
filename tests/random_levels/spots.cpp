#include "random_levels/spots.h"

#include <algorithm>

namespace hearth::random_levels {

namespace {

RandomSpot makeSpot(Random& random) {
  RandomSpot spot;
  spot.angle = random.pick({0.0, 90.0, -135.0, 360 * random.unit()});
  spot.pitch = random.pick({-90.0, -90.0, -45.0, 0.0, 180 * random.unit() - 90});
  spot.outer = random.pick({25.0, 40.0, 60.0, 90.0, 120.0, 180.0});
  // A jump of light at the edge of its cone comes last.
  spot.inner = spot.outer * random.pick({0.0, 0.25, 0.5, 0.8, 1.0});
  return spot;
}

}  // namespace

void makeSpots(Random& random, std::vector<RandomLight>& lights, std::set<Feature>& features) {
  for (RandomLight& light : lights) {
    if (!random.chance(0.5)) continue;
    light.spot = makeSpot(random);
    features.insert(Feature::SpotLight);
    if (light.spot->inner == light.spot->outer) features.insert(Feature::SpotWithAHardEdge);
    if (light.spot->outer > 90) features.insert(Feature::SpotWiderThanAPlane);
  }
}

}  // namespace hearth::random_levels
