#include "math/disc_area.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/trig.h"

namespace hearth {

namespace {

/// Of the disc between two directions, the shorter way round.
double sectorArea(Vec2 from, Vec2 to) {
  const double degrees = compassDegrees({dot(from, to), cross(from, to)});
  return (degrees > 180 ? degrees - 360 : degrees) * (std::numbers::pi / 360);
}

/// Of the triangle between the origin and an edge.
double triangleArea(Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double length2 = dot(along, along);
  const double half = dot(a, along);
  const double discriminant = half * half - length2 * (dot(a, a) - 1);
  if (!(discriminant > 0) || length2 == 0) return sectorArea(a, b);
  const double from = (-half - std::sqrt(discriminant)) / length2;
  const double to = (-half + std::sqrt(discriminant)) / length2;
  if (to <= 0 || from >= 1) return sectorArea(a, b);
  const Vec2 p = a + std::max(from, 0.0) * along;
  const Vec2 q = a + std::min(to, 1.0) * along;
  return (from > 0 ? sectorArea(a, p) : 0) + cross(p, q) / 2 + (to < 1 ? sectorArea(q, b) : 0);
}

}  // namespace

double areaInUnitDisc(std::span<const Vec2> polygon) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += triangleArea(polygon[i], polygon[(i + 1) % polygon.size()]);
  return area;
}

}  // namespace hearth
