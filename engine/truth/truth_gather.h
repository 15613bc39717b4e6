#pragma once

#include <cstdint>

#include "truth/truth_emission.h"
#include "truth/truth_light.h"

namespace hearth {

class GatherRays;

/// What a point gets from areas, in levels (255 is full) of red, green and blue.
struct AreaLight {
  Vec3 sky;
  Vec3 emitted;  ///< by surfaces that shine
  Vec3 bounced;  ///< of lights, suns, sky and emitters, by all bounces of the level

  Vec3 sum() const { return sky + emitted + bounced; }
};

/// The light of skies and shining surfaces at a point, and the light that bounces, as integrals of
/// the file format: by rays in random directions, spread evenly, and paths that go on from what
/// these meet (J. Kajiya, "The Rendering Equation", 1986). The reference for bakes.
class TruthGather {
 public:
  /// Rays in the first step: `side` x `side` directions, each in its own part of all, in each of
  /// `rounds`. Of these the standard error is found.
  struct Effort {
    int side = 16;
    int rounds = 16;
    std::uint64_t seed = 1;
  };

  struct Estimate {
    AreaLight light;
    AreaLight standardError;
  };

  /// Keeps references to the level and to the light of its lights and suns.
  TruthGather(const Level& level, const TruthLight& direct);

  /// The same for the same effort, whatever was asked before.
  Estimate at(const SurfacePoint& place, const Effort& effort) const;
  Estimate at(const SurfacePoint& place) const { return at(place, Effort()); }
  /// Of a point inside the air of a sector: from all around, without a cosine.
  Estimate at(const AirPoint& place, const Effort& effort) const;
  Estimate at(const AirPoint& place) const { return at(place, Effort()); }

 private:
  class Random;

  template <typename DirectionAt>
  Estimate estimate(const GatherRays& rays, const Effort& effort, Random random,
                    DirectionAt&& directionAt) const;
  AreaLight arriving(const GatherRays& rays, Vec3 direction, Random& random) const;
  Vec3 reflectanceOf(const TruthHit& hit) const;
  bool isFront(const TruthHit& hit, Vec3 direction) const;

  const Level& level_;
  const TruthLight& direct_;
  TruthEmission emission_;
  Vec3 sky_;  ///< levels at level ground in the open
};

}  // namespace hearth
