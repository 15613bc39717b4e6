#pragma once

#include <cmath>
#include <cstdint>

#include "math/vec.h"

namespace hearth::random_levels {

/// A length in micrometres. Whole micrometres make equal heights and shared vertices equal to the
/// bit, collinearity decidable, and every coordinate a decimal of at most six places.
using Um = std::int64_t;

inline constexpr Um kMetre = 1'000'000;
inline constexpr Um kMillimetre = 1'000;

constexpr double metres(Um length) { return static_cast<double>(length) / 1e6; }

struct Point {
  Um x = 0;
  Um y = 0;

  friend constexpr bool operator==(Point, Point) = default;
  friend constexpr auto operator<=>(Point, Point) = default;
};

constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
/// Exact: levels are at most 100 m across, so products stay below 2^55.
constexpr Um cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
constexpr Um dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
constexpr Vec2 metres(Point p) { return {metres(p.x), metres(p.y)}; }

/// To a micrometre, or a millionth of a degree: what an author would write.
inline double rounded(double v) { return std::floor(v * 1e6 + 0.5) / 1e6; }
inline Vec2 rounded(Vec2 v) { return {rounded(v.x), rounded(v.y)}; }

inline double distance(Point a, Point b) { return length(metres(b) - metres(a)); }

/// Metres from `p` to the segment `a`-`b`.
inline double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double t = dot(p - a, d) / dot(d, d);
  const double clamped = t < 0 ? 0 : t > 1 ? 1 : t;
  return length(p - lerp(a, b, clamped));
}

}  // namespace hearth::random_levels
