#include "math/trig.h"

#include <cmath>

namespace hearth {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadians = kPi / 180;

/// Taylor's series, |x| <= pi/4: the first term left out is below 2^-56.
double sinSeries(double x) {
  const double q = x * x;
  double sum = 0;
  for (int n = 17; n >= 3; n -= 2) sum = (1 + sum) * (-q / (n * (n - 1)));
  return x + x * sum;
}

double cosSeries(double x) {
  const double q = x * x;
  double sum = 0;
  for (int n = 18; n >= 2; n -= 2) sum = (1 + sum) * (-q / (n * (n - 1)));
  return 1 + sum;
}

/// Euler's halving brings the argument below tan(pi/16), where 15 terms suffice.
double atanSeries(double x) {
  for (int i = 0; i < 2; ++i) x = x / (1 + std::sqrt(1 + x * x));
  const double q = x * x;
  double sum = 0;
  for (int n = 29; n >= 1; n -= 2) sum = 1.0 / n - q * sum;
  return 4 * x * sum;
}

}  // namespace

SinCos sinCosDegrees(double angle) {
  const double turned = std::fmod(angle, 360.0);  // exact by definition
  const double quarter = std::floor(turned / 90 + 0.5);
  const double rest = (turned - 90 * quarter) * kRadians;
  const double s = sinSeries(rest);
  const double c = cosSeries(rest);
  switch (static_cast<int>(quarter) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double tanDegrees(double angle) {
  const auto [s, c] = sinCosDegrees(angle);
  return s / c;
}

Vec3 directionAt(double angle, double pitch) {
  const SinCos around = sinCosDegrees(angle);
  const SinCos up = sinCosDegrees(pitch);
  return {up.cos * around.cos, up.cos * around.sin, up.sin};
}

double atan(double tangent) {
  const double x = std::abs(tangent);
  return std::copysign(x <= 1 ? atanSeries(x) : kPi / 2 - atanSeries(1 / x), tangent);
}

double compassDegrees(Vec2 direction) {
  const double x = std::abs(direction.x);
  const double y = std::abs(direction.y);
  if (x == 0 && y == 0) return 0;
  double angle = x >= y ? atanSeries(y / x) / kRadians : 90 - atanSeries(x / y) / kRadians;
  if (direction.x < 0) angle = 180 - angle;
  if (direction.y < 0) angle = 360 - angle;
  return angle < 360 ? angle : 0;
}

double wrappedDegrees(double angle) {
  const double turned = std::fmod(angle, 360.0);
  const double positive = turned < 0 ? turned + 360 : turned;
  return positive < 360 ? positive : 0;  // a tiny negative angle rounds up to 360
}

}  // namespace hearth
