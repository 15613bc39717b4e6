#pragma once

#include "math/vec.h"

namespace hearth {

/// Trigonometry from IEEE operations only, so that it gives the same bits everywhere: the C
/// library's picks other code on other processors. Errors are below 2^-50 of the result's scale.

struct SinCos {
  double sin;
  double cos;
};

/// Of any finite angle in degrees; exact at multiples of 90.
SinCos sinCosDegrees(double angle);

/// For |angle| < 90 degrees.
double tanDegrees(double angle);

/// The direction of length 1 in which one looks: `angle` degrees on the map, 0 along +x, 90 along
/// +y, and `pitch` degrees up.
Vec3 directionAt(double angle, double pitch);

/// The angle, in radians, whose tangent is any number or an infinity.
double atan(double tangent);

/// The compass direction of a vector in degrees, in [0, 360): 0 along +x, 90 along +y. 0 for the
/// null vector.
double compassDegrees(Vec2 direction);

/// The angle in [0, 360) of the same direction as any finite angle, in degrees.
double wrappedDegrees(double angle);

}  // namespace hearth
