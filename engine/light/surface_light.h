#pragma once

#include <cstdint>
#include <vector>

#include "level/level.h"
#include "light/light_cost.h"
#include "light/light_sight.h"
#include "light/lit_surface.h"
#include "light/sample_placement.h"

namespace hearth {

/// What of the level's lights arrives at points of one surface.
class SurfaceLight {
 public:
  /// Keeps references to all but `id`.
  SurfaceLight(const Level& level, const LitSurfaces& surfaces, const LightSights& sights,
               bool lambert, SurfaceId id);

  const TexelRect& texels() const { return surface_.texels; }
  /// Indices of the lights that can shine on the surface's plane.
  const std::vector<std::size_t>& facing() const { return facing_; }
  const LightSource& light(std::size_t index) const { return level_.lights[index]; }
  /// 3 where one of the facing lights is coloured, else 1.
  int channels() const;

  SamplePoint place(Vec2 texelPoint) const;

  /// Which share of a light the point sees, 0..1.
  double seenShare(std::size_t light, const SamplePoint& at) {
    return seenShare(sights_.fine[light], light, at);
  }
  /// With fewer rays to a ball.
  double roughlySeenShare(std::size_t light, const SamplePoint& at) {
    return seenShare(sights_.rough[light], light, at);
  }

  /// What all of the light would bring to the point, in levels, before colour.
  double fullLevel(std::size_t light, const SamplePoint& at) const;

  /// In the order of the level's lights.
  const std::vector<LightCost>& costs() const { return costs_; }

 private:
  double seenShare(const LightSight& sight, std::size_t light, const SamplePoint& at);

  const Level& level_;
  const LitSurfaces& surfaces_;
  const LightSights& sights_;
  const LitSurface& surface_;
  SurfaceId id_;
  bool lambert_;
  SamplePlacement placement_;
  std::vector<std::size_t> facing_;
  std::vector<LightCost> costs_;
};

}  // namespace hearth
