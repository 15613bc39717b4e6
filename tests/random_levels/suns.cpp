#include "random_levels/suns.h"

namespace hearth::random_levels {

namespace {

RandomSun makeSun(Random& random, std::set<Feature>& features) {
  RandomSun sun;
  sun.angle = random.pick({0.0, 90.0, 45.0, 360 * random.unit(), 360 * random.unit()});
  sun.pitch = random.pick({90.0, 45.0, 1.0, 20.0, 1 + 89 * random.unit()});
  sun.intensity = random.pick({60.0, 120.0, 200.0});
  if (random.chance(0.5)) sun.size = random.pick({0.5, 6.0, 20.0});
  if (random.chance(0.3)) sun.color = random.pick({"#ffd0a0", "#808080"});
  features.insert(Feature::SunLight);
  if (sun.size > 0) features.insert(Feature::SunWithASize);
  if (sun.pitch == 90) features.insert(Feature::SunAtTheZenith);
  if (sun.pitch == 1) features.insert(Feature::SunAtTheHorizon);
  return sun;
}

}  // namespace

std::vector<RandomSun> makeSuns(Random& random, std::set<Feature>& features) {
  std::vector<RandomSun> suns;
  for (std::int64_t left = random.between(1, 2); left > 0; --left)
    suns.push_back(makeSun(random, features));
  return suns;
}

RandomSky makeSky(Random& random, std::set<Feature>& features) {
  RandomSky sky;
  sky.intensity = random.pick({40.0, 100.0, 200.0});
  if (random.chance(0.3)) sky.color = random.pick({"#a0c0ff", "#808080"});
  features.insert(Feature::LightOfSky);
  return sky;
}

}  // namespace hearth::random_levels
