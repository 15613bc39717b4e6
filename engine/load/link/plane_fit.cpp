#include "load/link/plane_fit.h"

#include <algorithm>
#include <cmath>

namespace hearth {

namespace {

/// Whether all points lie within `noise` of the line through the two that are farthest apart, as
/// far as the first one can tell.
bool areInLine(std::span<const Vec3> points, double noise) {
  if (points.size() < 3) return true;
  const Vec2 start = points[0].xy();
  const auto farthest =
      std::max_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
        return length(a.xy() - start) < length(b.xy() - start);
      });
  const Vec2 span = farthest->xy() - start;
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return std::abs(cross(span, p.xy() - start)) <= noise * length(span);
  });
}

}  // namespace

std::optional<PlaneFit> fitPlane(std::span<const Vec3> points, Vec2 origin, double noise) {
  if (areInLine(points, noise)) return std::nullopt;
  // Relative to the first point, so that level and axis-parallel wedges come out exact.
  const Vec3 base = points[0];
  const double weight = 1.0 / static_cast<double>(points.size());
  Vec3 mean;
  for (const Vec3& p : points) mean = mean + (p - base);
  mean = weight * mean;

  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (const Vec3& p : points) {
    const Vec3 d = (p - base) - mean;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
    xz += d.x * d.z;
    yz += d.y * d.z;
  }
  // Cramer's rule for the normal equations of z = z0 + gx x + gy y about the mean.
  const double determinant = xx * yy - xy * xy;
  const Vec2 gradient{(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant};
  const auto zAt = [&](Vec2 p) {
    return base.z + mean.z + dot(gradient, (p - base.xy()) - mean.xy());
  };
  double worst = 0;
  for (const Vec3& p : points) worst = std::max(worst, std::abs(zAt(p.xy()) - p.z));
  return PlaneFit{zAt(origin), gradient, worst};
}

}  // namespace hearth
