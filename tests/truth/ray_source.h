#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "embree_scene.h"
#include "level/locate.h"
#include "math/predicates.h"
#include "peers/level_mesh.h"

namespace hearth {

/// Rays from all over a level's air, of coordinates that both tracers take without rounding.
class RaySource {
 public:
  RaySource(const Scene& scene, std::uint64_t seed) : scene_(scene), random_(seed) {
    const Level& level = scene.level();
    for (std::size_t i = 0; i < level.sectors.size(); ++i)
      for (const auto& triangle : trianglesOf(level, level.sectors[i]))
        places_.push_back({SectorId(i), triangle});
  }

  struct Sample {
    SectorId sector;
    FloatRay ray;
  };

  /// In any direction.
  Sample anywhere() {
    const Start start = nextStart();
    return {start.sector, {start.origin, {unit(), unit(), unit()}}};
  }

  /// Towards an edge of a triangle, as near as single precision gets, or up to a millionth or a
  /// thousandth of its length beside it.
  Sample atAnEdgeOf(const std::vector<MeshTriangle>& mesh) {
    const Start start = nextStart();
    const auto& corners = mesh[random_() % mesh.size()].corners;
    const std::size_t first = random_() % 3;
    const Vec3 a = corners[first];
    const Vec3 b = corners[(first + 1) % 3];
    const double beside[] = {0, 1e-6, 1e-3};
    const double reach = length(b - a) * beside[random_() % 3];
    const Vec3 target = a + (0.5 + 0.5 * unit()) * (b - a) + reach * Vec3{unit(), unit(), unit()};
    return {start.sector, {start.origin, asFloat(target - asDouble(start.origin))}};
  }

  static Vec3 asDouble(const Float3& v) { return {v[0], v[1], v[2]}; }

 private:
  struct Place {
    SectorId sector;
    std::array<Vec2, 3> triangle;
  };

  struct Start {
    SectorId sector;
    Float3 origin;
  };

  Start nextStart() {
    for (;;) {
      const Place& place = places_[random_() % places_.size()];
      const Float3 origin = asFloat(pointAbove(place));
      if (isWellInside(scene_[place.sector], asDouble(origin))) return {place.sector, origin};
    }
  }

  static Float3 asFloat(Vec3 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }

  float unit() { return static_cast<float>(static_cast<double>(random_() >> 11) * 0x1p-52 - 1); }

  Vec3 pointAbove(const Place& place) {
    const auto& [a, b, c] = place.triangle;
    const Vec2 xy = lerp(lerp(a, b, 0.5 + 0.5 * unit()), c, 0.5 + 0.5 * unit());
    const Sector& sector = scene_[place.sector];
    return {xy.x, xy.y,
            std::lerp(scene_.airBottom(sector, xy), scene_.airTop(sector, xy), 0.5 + 0.5 * unit())};
  }

  /// 1 mm from all walls and flats: more than single precision moves them.
  bool isWellInside(const Sector& sector, Vec3 p) const {
    constexpr double kClearance = 1e-3;
    if (!contains(scene_, sector, p, 0)) return false;
    if (p.z - scene_.airBottom(sector, p.xy()) < kClearance) return false;
    if (scene_.airTop(sector, p.xy()) - p.z < kClearance) return false;
    for (const Segment& segment : scene_.segmentsOf(sector))
      if (length(nearestOnSegment(segment.p0, segment.p1, p.xy()) - p.xy()) < kClearance)
        return false;
    return true;
  }

  Scene scene_;
  std::mt19937_64 random_;
  std::vector<Place> places_;
};

}  // namespace hearth
