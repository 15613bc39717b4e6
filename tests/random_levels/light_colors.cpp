#include "random_levels/light_colors.h"

#include <fmt/format.h>

namespace hearth::random_levels {

namespace {

using Curve = std::vector<std::array<double, 2>>;

std::string makeColor(Random& random, std::set<Feature>& features) {
  if (random.chance(0.2)) {
    features.insert(Feature::GreyLight);
    return random.pick({"#808080", "#c3c3c3"});
  }
  features.insert(Feature::ColoredLight);
  if (random.chance(0.3)) return random.pick({"#ff0000", "#0000ff", "#ffff00"});
  return fmt::format("#{:06x}", random.between(0, 0xFFFFFF));
}

Curve makeCurve(Random& random) {
  Curve curve;
  double distance = random.pick({0.0, 0.0, 0.5, 1.25});
  for (std::int64_t points = random.between(1, 4); points > 0; --points) {
    const double level = random.pick({0.0, 30.0, 90.5, 150.0, 200.0, 255.0});
    curve.push_back({distance, level});
    if (random.chance(0.3) && points > 1) {
      curve.push_back({distance, level < 100 ? level + 90 : level - 70});
      --points;
    }
    distance += random.pick({0.75, 1.0, 1.5, 3.0});
  }
  return curve;
}

void noteCurve(const Curve& curve, std::set<Feature>& features) {
  features.insert(Feature::LightCurve);
  if (curve.size() == 1) features.insert(Feature::CurveOfOnePoint);
  if (curve.front()[0] > 0) features.insert(Feature::CurveFromBeyondZero);
  const bool endsNear = curve.back()[0] < 3 && curve.back()[1] > 0;
  if (endsNear) features.insert(Feature::CurveGoesOnPastItsEnd);
  for (std::size_t i = 0; i + 1 < curve.size(); ++i)
    if (curve[i][0] == curve[i + 1][0]) features.insert(Feature::CurveJump);
}

}  // namespace

void makeColorsAndCurves(Random& random, std::vector<RandomLight>& lights,
                         std::set<Feature>& features) {
  for (RandomLight& light : lights) {
    if (random.chance(0.4)) light.color = makeColor(random, features);
    if (!random.chance(0.25)) continue;
    light.curve = makeCurve(random);
    noteCurve(light.curve, features);
  }
}

}  // namespace hearth::random_levels
