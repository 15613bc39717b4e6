#pragma once

#include <vector>

#include "truth/trace.h"

namespace hearth {

/// A point in the air of a sector, or for lights also beyond its sky.
struct AirPoint {
  Vec3 point;
  SectorId sector;
};

/// One light, as points of surfaces and of the air see it.
class TruthSource {
 public:
  /// Keeps a reference to the level. A ball of light is so many points.
  TruthSource(const Level& level, const LightSource& light, int ballPoints);

  /// The fraction of the light that sees the point, 0..1.
  double seenFraction(const SurfacePoint& place) const;
  double seenFraction(const AirPoint& place) const;

  /// The levels (255 is full) that the light would add if it were white and nothing stood between,
  /// at a point that need not lie on a surface; 0 in the plane of the light. Multiplied by the
  /// cosine at the surface with `lambert`.
  static double unshaded(const LightSource& light, const SurfacePoint& place, bool lambert);

  /// The first surface that its light meets on the way to the point: from its centre or, if nothing
  /// stops that, from the first point of the ball that something stops. None if only skies do.
  std::optional<TruthHit> firstMet(const SurfacePoint& place) const;

 private:
  bool sees(const AirPoint& origin, const SurfacePoint& place) const;
  bool sees(const AirPoint& origin, const AirPoint& place) const;

  const Level& level_;
  AirPoint center_;
  /// From which it shines: many points of a ball, all alike; one of a point light. The points of a
  /// ball that its centre does not see shine nowhere.
  std::vector<AirPoint> origins_;
  int count_ = 1;  ///< with those that shine nowhere
};

/// The light at points of surfaces and of the air as the file format defines it, not as any bake
/// samples it: the reference for bakes.
class TruthLight {
 public:
  /// Of a ball. The fraction of it that lies before a plane is right within 0.4 % then.
  static constexpr int kBallPoints = 20000;

  /// Keeps a reference to the level. A ball of light is so many points.
  explicit TruthLight(const Level& level, int ballPoints = kBallPoints);

  /// Levels (255 is full) of red, green and blue, neither clamped nor rounded: the sum over the
  /// lights that see the point.
  Vec3 at(const SurfacePoint& place) const;
  /// The same of a point in the air of its sector, off its walls and flats: without a cosine.
  Vec3 at(const AirPoint& place) const;

  /// The levels that the light of that index would add if it were white; 0 if it does not see the
  /// point.
  double from(std::size_t light, const SurfacePoint& place) const;
  double from(std::size_t light, const AirPoint& place) const;

  /// The fraction of the light that sees the point, 0..1.
  double seenFraction(std::size_t light, const SurfacePoint& place) const;

  /// The levels that it would add if nothing stood between, at a point that need not lie on a
  /// surface; 0 in the plane of the light.
  double unshaded(std::size_t light, const SurfacePoint& place) const;

 private:
  template <typename Place>
  Vec3 sumAt(const Place& place) const;

  const Level& level_;
  std::vector<TruthSource> sources_;  ///< by index of light
};

}  // namespace hearth
