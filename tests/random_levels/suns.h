#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "random_levels/feature.h"
#include "random_levels/model.h"
#include "random_levels/random.h"

namespace hearth::random_levels {

/// Angles in degrees, as in a lights file.
struct RandomSun {
  double angle = 0;
  double pitch = 90;
  double intensity = 255;
  double size = 0;
  std::string color;  ///< "#rrggbb"; none when empty
};

/// As in a lights file.
struct RandomSky {
  double intensity = 0;
  std::string color;  ///< "#rrggbb"; none when empty
};

/// Lights without a place.
struct FarLights {
  std::vector<RandomSun> suns;
  std::optional<RandomSky> sky;

  bool areNone() const { return suns.empty() && !sky; }
};

/// A sun or two, high and low, also along walls and edges of shadows; notes which kinds.
std::vector<RandomSun> makeSuns(Random& random, std::set<Feature>& features);
/// The light of the sky; notes it.
RandomSky makeSky(Random& random, std::set<Feature>& features);

}  // namespace hearth::random_levels
