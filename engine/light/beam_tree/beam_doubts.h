#pragma once

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

#include "level/scene.h"
#include "light/beam_tree/beam.h"

namespace hearth {

/// Records where a light's beams give no certain answer, and all sectors that its rays can enter
/// from there.
class BeamDoubts {
 public:
  /// `found` must outlive it.
  BeamDoubts(const Scene& scene, Vec3 light, BeamSet& found)
      : scene_(scene), light_(light.xy()), found_(found) {}

  /// A direction in which rounding decides which walls rays meet: along it, all sectors that rays
  /// can enter from this one on are doubtful.
  void addLine(SectorId from, Vec2 direction);

  /// From now on nothing is known of these sectors, and of those that rays can enter from there.
  void forget(std::vector<SectorId> sectors);

 private:
  Vec2 fromLight(Vec2 p) const { return p - light_; }
  bool touches(const Segment& wall, Vec2 direction) const;
  template <typename Visit>
  void forEachBehindFlats(SectorId id, Visit&& visit) const;
  template <typename Visit>
  void forEachWallAlong(SectorId id, Vec2 direction, Visit&& visit) const;

  Scene scene_;
  Vec2 light_;
  BeamSet& found_;
  std::set<std::tuple<std::uint32_t, double, double>> lines_;
};

}  // namespace hearth
