#pragma once

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

#include "level/scene.h"
#include "light/beam_tree/beam.h"

namespace hearth {

/// Notes where a light's beams say nothing certain, and all that its rays can come to from there.
class BeamDoubts {
 public:
  /// `found` must outlive it.
  BeamDoubts(const Scene& scene, Vec3 light, BeamSet& found)
      : scene_(scene), light_(light.xy()), found_(found) {}

  /// A direction in which rounding decides which walls rays meet: whatever they can come to from
  /// the sector on is doubtful along it.
  void addLine(SectorId from, Vec2 direction);

  /// Says nothing of sectors any more, and of what rays can come to from there.
  void forget(std::vector<SectorId> sectors);

 private:
  Vec2 fromLight(Vec2 p) const { return p - light_; }
  bool touches(const Segment& wall, Vec2 direction) const;
  template <typename Visit>
  void forEachBehindFlats(SectorId id, Visit&& visit) const;

  Scene scene_;
  Vec2 light_;
  BeamSet& found_;
  std::set<std::tuple<std::uint32_t, double, double>> lines_;
};

}  // namespace hearth
