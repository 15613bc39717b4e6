#include "edge_distance.h"

#include <algorithm>
#include <limits>

namespace hearth {

namespace {

struct Line {
  Vec3 from;
  Vec3 to;
};

double distanceToPoint(const Line& line, Vec3 p) {
  const Vec3 along = line.to - line.from;
  const double squared = dot(along, along);
  const double fraction =
      squared > 0 ? std::clamp(dot(p - line.from, along) / squared, 0.0, 1.0) : 0;
  return length(p - (line.from + fraction * along));
}

/// Distance of two straight pieces: at the feet of their common perpendicular if both have them,
/// else at one of the four ends.
double distanceBetween(const Line& p, const Line& q) {
  double nearest = std::min({distanceToPoint(p, q.from), distanceToPoint(p, q.to),
                             distanceToPoint(q, p.from), distanceToPoint(q, p.to)});
  const Vec3 a = p.to - p.from;
  const Vec3 b = q.to - q.from;
  const Vec3 w = p.from - q.from;
  const double determinant = dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b);
  if (determinant > 0) {
    const double s = (dot(a, b) * dot(b, w) - dot(b, b) * dot(a, w)) / determinant;
    const double t = (dot(a, a) * dot(b, w) - dot(a, b) * dot(a, w)) / determinant;
    if (0 <= s && s <= 1 && 0 <= t && t <= 1)
      nearest = std::min(nearest, length(w + s * a - t * b));
  }
  return nearest;
}

}  // namespace

double distanceToEdge(const MeshTriangle& triangle, Vec3 from, Vec3 to) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
    nearest = std::min(
        nearest, distanceBetween({from, to}, {triangle.corners[i], triangle.corners[(i + 1) % 3]}));
  return nearest;
}

}  // namespace hearth
