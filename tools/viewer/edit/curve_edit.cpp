#include "viewer/edit/curve_edit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/check.h"

namespace hearth {

namespace {

double toThousandths(double number) { return std::round(1000 * number) / 1000; }

/// About half way, on the line between the two.
CurvePoint between(CurvePoint a, CurvePoint b) {
  const double length = b.distance - a.distance;
  const double middle = toThousandths(std::midpoint(a.distance, b.distance));
  const double distance = std::clamp(middle, a.distance, b.distance);
  const double fraction = length > 0 ? (distance - a.distance) / length : 0.5;
  return {distance, toThousandths(std::lerp(a.level, b.level, fraction))};
}

}  // namespace

std::vector<CurvePoint> withPointBehind(std::vector<CurvePoint> curve, std::size_t index) {
  const CurvePoint point = curve[index];
  const bool isLast = index + 1 == curve.size();
  curve.insert(
      curve.begin() + static_cast<std::ptrdiff_t>(index) + 1,
      isLast ? CurvePoint{point.distance + 1, point.level} : between(point, curve[index + 1]));
  return curve;
}

std::vector<CurvePoint> withoutPoint(std::vector<CurvePoint> curve, std::size_t index) {
  CHECK(curve.size() > 1, index);
  curve.erase(curve.begin() + static_cast<std::ptrdiff_t>(index));
  return curve;
}

}  // namespace hearth
