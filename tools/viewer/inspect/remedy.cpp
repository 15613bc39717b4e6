#include "viewer/inspect/remedy.h"

#include <cmath>

namespace hearth {

namespace {

/// Per metre. A light that fell off by less would light all of the level.
constexpr double kLeastFalloff = 0.01;

/// The unit of a number's second digit.
double secondDigit(double number) { return std::pow(10, std::floor(std::log10(number)) - 1); }

/// To two digits.
double raised(double number) {
  return std::ceil(number / secondDigit(number)) * secondDigit(number);
}
double lowered(double number) {
  return std::floor(number / secondDigit(number)) * secondDigit(number);
}

}  // namespace

std::optional<Remedy> remedyFor(const LightSource& light, const LightFinding& finding) {
  const double fraction = light.greatestFactor();
  if (fraction == 0) return std::nullopt;
  // The cosine, and what a spot leaves of its light.
  const double full = light.hasPlace() ? light.brightnessAt(finding.distance) : light.intensity;
  const double shading = full > 0 ? finding.unshaded / full : 1;
  const double needed = kClearLevel / (fraction * shading);
  if (!light.curve.empty()) return Remedy{.curveLevel = raised(needed)};
  if (!light.hasPlace()) return Remedy{.intensity = raised(needed)};
  // What makes `brightnessAt` the level that is needed.
  const double falloff = (light.intensity / needed - 1) / finding.distance;
  if (falloff >= kLeastFalloff) return Remedy{.falloff = lowered(falloff)};
  return Remedy{.intensity = raised(needed * (finding.distance * light.falloff + 1))};
}

}  // namespace hearth
