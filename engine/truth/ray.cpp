#include "truth/ray.h"

#include <algorithm>
#include <cmath>

namespace hearth {

Ray makeRay(Vec3 origin, Vec3 direction, RayKind kind) {
  // 2^40 m: beyond any level, and so far that the rounding of the origin's coordinates does not
  // show.
  const double largest = std::max(std::abs(direction.x), std::abs(direction.y));
  const int power = largest > 0 ? 40 - std::ilogb(largest) : 0;
  const Vec2 reach{std::ldexp(direction.x, power), std::ldexp(direction.y, power)};
  return {origin, direction, kind, origin.xy() + reach};
}

}  // namespace hearth
