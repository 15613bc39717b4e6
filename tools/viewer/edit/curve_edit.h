#pragma once

#include <cstddef>
#include <vector>

#include "level/light_source.h"

/// Edits of the points of a light's curve, which stay sorted by distance.
namespace hearth {

/// The curve with one more point behind the one at `index`: half way to the next, or a metre behind
/// the last. The new point lies on the curve, so the light stays the same within a thousandth.
std::vector<CurvePoint> withPointBehind(std::vector<CurvePoint> curve, std::size_t index);

/// Expects another point.
std::vector<CurvePoint> withoutPoint(std::vector<CurvePoint> curve, std::size_t index);

}  // namespace hearth
