#pragma once

#include <cstddef>
#include <vector>

#include "level/light_source.h"

/// Points of a light's curve, which are sorted by distance and stay so.
namespace hearth {

/// With one more behind the point at `index`, where the curve has it already, so that the light
/// stays as it is within a thousandth: half way to the next, or a metre behind the last.
std::vector<CurvePoint> withPointBehind(std::vector<CurvePoint> curve, std::size_t index);

/// Expects: there is another.
std::vector<CurvePoint> withoutPoint(std::vector<CurvePoint> curve, std::size_t index);

}  // namespace hearth
