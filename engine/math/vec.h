#pragma once

#include <cmath>

namespace hearth {

/// A point or direction on the map, in metres: x to the right, y down the map.
struct Vec2 {
  double x = 0;
  double y = 0;

  friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator*(double k, Vec2 a) { return {k * a.x, k * a.y}; }
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Positive when `b` lies clockwise of `a` as seen on the map (y down).
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
/// Of length 1; `a` is not 0.
inline Vec2 unit(Vec2 a) { return (1 / length(a)) * a; }
/// `a` turned by +90 degrees: from +x towards +y.
constexpr Vec2 turned90(Vec2 a) { return {-a.y, a.x}; }
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) { return a + t * (b - a); }
/// Order by x, then by y: the order in which vertices are said to be "first".
constexpr bool lessXY(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// A point or direction in the world, in metres: x and y as on the map, z up.
struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;

  constexpr Vec2 xy() const { return {x, y}; }
  friend constexpr bool operator==(Vec3, Vec3) = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(double k, Vec3 a) { return {k * a.x, k * a.y, k * a.z}; }
/// Each component of one times that of the other.
constexpr Vec3 product(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }

}  // namespace hearth
