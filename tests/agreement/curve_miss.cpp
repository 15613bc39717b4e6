#include "agreement/curve_miss.h"

#include <algorithm>
#include <cmath>

namespace hearth::agreement {

namespace {

/// Levels a metre; 0 across a jump, and past the ends.
double slopeAfter(const std::vector<CurvePoint>& curve, std::size_t i) {
  if (i + 1 == curve.size() || curve[i].distance == curve[i + 1].distance) return 0;
  return (curve[i + 1].level - curve[i].level) / (curve[i + 1].distance - curve[i].distance);
}

}  // namespace

double jumpsBetween(const std::vector<CurvePoint>& curve, double nearest, double farthest) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const double distance = curve[i].distance;
    if (curve[i + 1].distance != distance || distance < nearest || distance > farthest) continue;
    sum += std::abs(curve[i + 1].level - curve[i].level);
  }
  return sum;
}

double missAtBends(const std::vector<CurvePoint>& curve,
                   const std::vector<WeightedDistance>& places) {
  double miss = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double bend = slopeAfter(curve, i) - (i > 0 ? slopeAfter(curve, i - 1) : 0);
    // What lies past the bend adds to the mean; the mean itself may not lie past it.
    double interpolated = 0;
    double beyond = 0;
    for (const WeightedDistance& place : places) {
      interpolated += place.weight * std::max(0.0, place.metres - curve[i].distance);
      beyond += place.weight * (place.metres - curve[i].distance);
    }
    miss += std::abs(bend) * (interpolated - std::max(0.0, beyond));
  }
  return miss;
}

double missOfSlope(const std::vector<CurvePoint>& curve, double metres, double texel) {
  double slope = 0;
  for (std::size_t i = 0; i < curve.size() && curve[i].distance <= metres; ++i)
    slope = slopeAfter(curve, i);
  // The distance d curves by 1/d at most, both ways along a plane.
  return std::abs(slope) * texel * texel / (4 * metres);
}

double jumpOfSpot(const LightSource& light, Vec3 place, double slack) {
  if (!light.spot || light.spot->inner() != light.spot->outer()) return 0;
  const Vec3 offset = place - light.position;
  return std::abs(light.spot->beyondEdge(offset)) <= slack ? light.brightnessAt(length(offset)) : 0;
}

double missOfSpot(const Spot& spot, double metres, double texel) {
  const double range = spot.cosInner() - spot.cosOuter();
  if (range == 0) return 1;
  // The profile's first two derivatives are 3/2 and 6 at most, over the range; those of the cosine
  // 1/d and 2/d^2, along each axis of the texels.
  const double bend = (6 / (range * range) + 3 / range) / (metres * metres);
  return std::min(1.0, bend * texel * texel / 4);
}

}  // namespace hearth::agreement
