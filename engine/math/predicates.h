#pragma once

#include "math/vec.h"

namespace hearth {

/// Sign of the area of the triangle a, b, c, exact for all finite input whose products neither
/// overflow nor underflow: > 0 when c lies in front of the segment a -> b, < 0 behind it, 0 on its
/// line. A floating-point filter decides nearly all cases; the rest is summed without rounding
/// (Shewchuk, "Adaptive Precision Floating-Point Arithmetic", 1997).
int orientation(Vec2 a, Vec2 b, Vec2 c);

/// Whether a ray from `eye` that meets two segments meets a before b; the segments do not cross.
/// Exact, also if they share an end point. False for segments of one line.
bool meetsFirst(Vec2 eye, Vec2 a0, Vec2 a1, Vec2 b0, Vec2 b1);

/// The point of the segment a -> b that is nearest to p.
inline Vec2 nearestOnSegment(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 ab = b - a;
  const double fraction = dot(p - a, ab) / dot(ab, ab);
  if (!(fraction > 0)) return a;
  return fraction < 1 ? a + fraction * ab : b;
}

}  // namespace hearth
