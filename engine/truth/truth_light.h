#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "truth/trace.h"
#include "truth/truth_meshes.h"

namespace hearth {

/// A point in the air of a sector, or for lights also beyond its sky.
struct AirPoint {
  Vec3 point;
  SectorId sector;
};

/// The place as light falls on it: on a mesh's face always from its front, whichever side is seen.
SurfacePoint litSideOf(const Level& level, SurfacePoint place);

/// One light, as points of surfaces and of the air see it. Meshes stop its light where it crosses
/// the air of a sector that they are in. They take no part of a ball that they reach into.
class TruthSource {
 public:
  /// Keeps references to the level and its meshes. A ball of light is so many points.
  TruthSource(const Level& level, const TruthMeshes& meshes, const LightSource& light,
              int ballPoints);

  /// The fraction of the light that sees the point, 0..1.
  double seenFraction(const SurfacePoint& place) const;
  double seenFraction(const AirPoint& place) const;

  /// The levels (255 is full) that the light would add if it were white and nothing stood between,
  /// at a point that need not lie on a surface; 0 in the plane of the light. Multiplied by the
  /// cosine at the surface with `lambert`, on the side to which the place's normal points.
  static double unshaded(const LightSource& light, const SurfacePoint& place, bool lambert);

  /// The first surface that its light meets on the way to the point: from its centre or, if nothing
  /// stops that, from the first point of the ball that something stops. None if only skies do.
  std::optional<TruthHit> firstMet(const SurfacePoint& place) const;

 private:
  struct Arrival {
    bool arrives;
    std::optional<TruthHit> stop;  ///< none too if only skies stop it
  };

  bool sees(const AirPoint& origin, const SurfacePoint& place) const;
  bool sees(const AirPoint& origin, const AirPoint& place) const;
  /// Of its light at the place.
  Arrival arrivalAt(const SurfacePoint& place, const AirPoint& origin) const;

  const Level& level_;
  const TruthMeshes& meshes_;
  AirPoint center_;
  /// From which it shines: many points of a ball, all alike; one of a point light. The points of a
  /// ball that its centre does not see shine nowhere.
  std::vector<AirPoint> origins_;
  int count_ = 1;  ///< with those that shine nowhere
};

/// One sun, as points of surfaces and of the air see it.
class TruthSun {
 public:
  /// Keeps references to the level and its meshes. The disc of a sun with a size is so many points.
  TruthSun(const Level& level, const TruthMeshes& meshes, const Sun& sun, int discPoints);

  /// The fraction of its disc that sees the point, 0..1.
  double seenFraction(const SurfacePoint& place) const;
  double seenFraction(const AirPoint& place) const;

  /// As for a TruthSource, of the first surface on the way towards it.
  std::optional<TruthHit> firstMet(const SurfacePoint& place) const;

 private:
  const Level& level_;
  const TruthMeshes& meshes_;
  std::vector<Vec3> directions_;  ///< spread evenly over its solid angle, of length 1
};

/// A light that is an area has no single direction: see TruthGather.
struct TruthOfNoDirection {
  static double seenFraction(const auto&) { return 0; }
};

/// The light of lights, suns among them, but for areas, at points of surfaces, of meshes and of the
/// air as the file format defines it, not as any bake samples it: the reference for bakes.
class TruthLight {
 public:
  /// Of a ball. The fraction of it that lies before a plane is right within 0.4 % then.
  static constexpr int kBallPoints = 20000;

  /// Keeps a reference to the level. A ball of light is so many points, and so is the disc of a
  /// sun.
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

  /// The meshes of the level.
  const TruthMeshes& meshes() const { return *meshes_; }

 private:
  template <typename Place>
  Vec3 sumAt(const Place& place) const;

  const Level& level_;
  std::shared_ptr<const TruthMeshes> meshes_;  ///< at one address, as the sources refer to them
  std::vector<std::variant<TruthSource, TruthSun, TruthOfNoDirection>>
      sources_;  ///< by index of light
};

}  // namespace hearth
