#pragma once

#include <span>

#include "math/vec.h"

namespace hearth {

/// The area that a polygon and the disc of radius 1 around the origin have in common; positive if
/// the polygon goes round from +x towards +y. Of polygons that cross themselves, the parts have
/// their own signs.
double areaInUnitDisc(std::span<const Vec2> polygon);

}  // namespace hearth
