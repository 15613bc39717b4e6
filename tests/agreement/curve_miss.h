#pragma once

#include <vector>

#include "level/light_source.h"

namespace hearth::agreement {

/// A place that light is interpolated from.
struct WeightedDistance {
  double metres;  ///< from the light
  double weight;  ///< of all places together 1
};

/// Levels of the curve's jumps at distances from `nearest` to `farthest`, in metres.
double jumpsBetween(const std::vector<CurvePoint>& curve, double nearest, double farthest);

/// Levels by which light interpolated between the places misses the curve because of its bends.
double missAtBends(const std::vector<CurvePoint>& curve,
                   const std::vector<WeightedDistance>& places);

/// Levels by which it misses the curve `metres` from the light over texels of `texel` metres
/// because the distance to the light does not grow evenly.
double missOfSlope(const std::vector<CurvePoint>& curve, double metres, double texel);

/// Levels by which a spot's light jumps no farther than `slack` metres from a place.
double jumpOfSpot(const LightSource& light, Vec3 place, double slack);

/// Fraction of a spot's light by which it misses the spot's profile, `metres` from the light over
/// texels of `texel` metres.
double missOfSpot(const Spot& spot, double metres, double texel);

}  // namespace hearth::agreement
