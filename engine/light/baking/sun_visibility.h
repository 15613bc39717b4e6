#pragma once

#include <cstdint>
#include <span>

#include "level/scene.h"
#include "light/baking/light_target.h"
#include "light/rays/raytracer.h"

namespace hearth {

/// Answers which fraction of a sun's disc, by solid angle, a point sees: all or nothing of a sun
/// without a size.
class SunVisibility {
 public:
  /// The disc is divided into about `softSamples` cells, as many across as down, and straight edges
  /// of shadows cut the cells exactly. With 0 a sun is a point. `solidMaskedMiddles`: see
  /// BakeSettings.
  SunVisibility(const Scene& scene, const Sun& sun, int softSamples, bool solidMaskedMiddles);

  /// 0..1. Adds the number of its rays to `rays`, and the sectors that they enter to `met`, if any.
  double seenFraction(const LightTarget& target, std::int64_t& rays,
                      SectorSet* met = nullptr) const;
  /// The same for a target of a shaft along `cone()`, whose rays have this outcome.
  double seenFraction(const LightTarget& target, const SkyShaft& shaft, TargetVisibility outcome,
                      std::int64_t& rays) const;
  /// The same for a point inside the air of a sector, which no surface hides from any side.
  double seenFractionFromAir(Vec3 point, SectorId sector, std::int64_t& rays) const;
  /// The same for a point of a mesh's face, in the air of a sector: a target of the shaft.
  double seenFraction(const FacePoint& target, SectorId sector, const SkyShaft& shaft,
                      std::int64_t& rays) const;
  /// The same for a corner of faces, none of which hides the sun from it as far as it is behind the
  /// face.
  double seenFractionFromCorner(Vec3 corner, std::uint32_t mesh, SectorId sector,
                                const SkyShaft& shaft, std::int64_t& rays) const;
  /// The fraction of the disc in front of a plane, by its unit normal.
  double fractionInFront(Vec3 normal) const;

  /// Around all rays: those to the corners of the square around the disc.
  const SunCone& cone() const { return cone_; }

 private:
  template <typename Sees>
  double seenFractionBy(Sees&& sees) const;
  Vec3 directionTo(Vec2 onDisc) const;
  Raytracer::Source startAt(Vec3 point, SectorId sector) const;

  Scene scene_;
  Raytracer raytracer_;
  double sinRim_;      ///< of the angle between its middle and its rim; 0 for a point
  double squaredRim_;  ///< (2 sin(a / 2))^2 of that angle
  SunCone cone_;
  int cells_;   ///< along the disc's diameter; 0 for a point
  Vec3 right_;  ///< unit, with `up_` across the direction
  Vec3 up_;
};

}  // namespace hearth
